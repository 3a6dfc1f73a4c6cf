#include "scene/graph.hpp"

#include "scene/singular_reason.hpp"

namespace trace {
namespace {

Vec3 vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

LocalTransform local_transform(const parser::Translate& t) {
  return translation(vector(t.offset));
}
LocalTransform local_transform(const parser::Rotate& r) {
  return rotation(vector(r.axis), r.angle);
}
LocalTransform local_transform(const parser::Scale& s) {
  return scaling(vector(s.factors));
}
// Written row by row; GLM's matrices are columns.
LocalTransform local_transform(const parser::Transform& t) {
  Mat4 m;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) m[column][row] = t.rows[row][column];
  }
  return given_matrix(m);
}
template <class Other>
LocalTransform local_transform(const Other&) {
  return {};
}

class GraphBuilder {
 public:
  explicit GraphBuilder(const parser::Scene& description) : description_(description) {
    places_.emplace_back();
  }

  SceneGraph build() {
    for (const parser::Item& item : description_.items) {
      if (const auto* material = std::get_if<parser::Material>(&item)) {
        material_ = push_material(*material, material_);
      } else if (const auto* root = std::get_if<parser::ElementId>(&item)) {
        add_tree(*root);
      }
    }
    for (Singular& singular : singular_) {
      if (singular.has_objects) graph_.singular.push_back(std::move(singular.transform));
    }
    return std::move(graph_);
  }

 private:
  static constexpr std::int64_t none = -1;

  struct Place {
    std::int64_t frame = none;     // in the graph, once an object uses it
    std::int64_t singular = none;  // in singular_, where the place has no inverse
  };

  struct Singular {
    SingularTransform transform;
    bool has_objects = false;
  };

  // Elements still to visit on one level, and what holds there.
  struct Level {
    parser::ElementId next;
    std::size_t place;
    MaterialScopeId material;
    Placement placement;
  };

  void add_tree(parser::ElementId root) {
    std::vector<Level> levels{{root, 0, material_, {}}};
    for (bool at_root = true; !levels.empty(); at_root = false) {
      Level& level = levels.back();
      if (level.next == parser::no_element) {
        levels.pop_back();
        continue;
      }
      const parser::Element& element = description_.elements[level.next];
      level.next = at_root ? parser::no_element : element.next_sibling;
      if (const auto* primitive = std::get_if<parser::Primitive>(&element.what)) {
        add_object(element, *primitive, level);
      } else if (const auto* material = std::get_if<parser::Material>(&element.what)) {
        level.material = push_material(*material, level.material);
      } else {
        Level inner = level;
        inner.next = element.first_child;
        if (!std::holds_alternative<parser::Group>(element.what)) enter(element, inner);
        // The last on a level leaves nothing to return to: chains of transforms take no memory.
        if (level.next == parser::no_element) levels.pop_back();
        levels.push_back(inner);
      }
    }
  }

  // Goes into the place that a transform makes.
  void enter(const parser::Element& transform, Level& level) {
    const LocalTransform local =
        std::visit([](const auto& what) { return local_transform(what); }, transform.what);
    level.placement = level.placement.inside(local);
    Place place;
    place.singular = places_[level.place].singular;
    if (place.singular == none && !level.placement.reliable() && !Frame(level.placement).invertible()) {
      place.singular = static_cast<std::int64_t>(singular_.size());
      singular_.push_back({{transform.keyword, singular_reason(transform.what, level.placement)}});
    }
    level.place = places_.size();
    places_.push_back(place);
  }

  void add_object(const parser::Element& element, const parser::Primitive& primitive, const Level& level) {
    Place& place = places_[level.place];
    if (place.singular != none) {
      singular_[static_cast<std::size_t>(place.singular)].has_objects = true;
    } else if (place.frame == none) {
      place.frame = static_cast<std::int64_t>(graph_.frames.size());
      graph_.frames.emplace_back(level.placement);
    }
    graph_.objects.push_back(
        {&primitive, element.span, element.keyword, place.frame, level.material, graph_.materials.size()});
  }

  MaterialScopeId push_material(const parser::Material& material, MaterialScopeId inherits) {
    graph_.materials.push_back({&material, inherits});
    return static_cast<MaterialScopeId>(graph_.materials.size() - 1);
  }

  const parser::Scene& description_;
  SceneGraph graph_;
  std::vector<Place> places_;
  std::vector<Singular> singular_;
  MaterialScopeId material_ = default_material;
};

}  // namespace

SceneGraph make_graph(const parser::Scene& description) {
  return GraphBuilder(description).build();
}

}  // namespace trace
