#include "scene/graph.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace trace {
namespace {

Vec3 vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

struct LocalMatrix {
  Mat4 operator()(const parser::Translate& t) const { return glm::translate(Mat4(1), vector(t.offset)); }
  Mat4 operator()(const parser::Rotate& r) const { return glm::rotate(Mat4(1), r.angle, vector(r.axis)); }
  Mat4 operator()(const parser::Scale& s) const { return glm::scale(Mat4(1), vector(s.factors)); }
  // Written row by row; GLM's matrices are columns.
  Mat4 operator()(const parser::Transform& t) const {
    Mat4 m;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) m[column][row] = t.rows[row][column];
    }
    return m;
  }
  template <class Other>
  Mat4 operator()(const Other&) const {
    return Mat4(1);
  }
};

class GraphBuilder {
 public:
  explicit GraphBuilder(const parser::Scene& description) : description_(description) {
    graph_.nodes.emplace_back();
  }

  SceneGraph build() {
    for (const parser::Item& item : description_.items) {
      if (const auto* material = std::get_if<parser::Material>(&item)) {
        material_ = push_material(*material, material_);
      } else if (const auto* root = std::get_if<parser::ElementId>(&item)) {
        add_tree(*root);
      }
    }
    return std::move(graph_);
  }

 private:
  // Elements still to visit on one level, and what holds there.
  struct Level {
    parser::ElementId next;
    std::uint32_t node;
    MaterialScopeId material;
  };

  void add_tree(parser::ElementId root) {
    std::vector<Level> levels{{root, 0, material_}};
    while (!levels.empty()) {
      Level& level = levels.back();
      if (level.next == parser::no_element) {
        levels.pop_back();
        continue;
      }
      const parser::Element& element = description_.elements[level.next];
      level.next = levels.size() == 1 ? parser::no_element : element.next_sibling;
      if (const auto* primitive = std::get_if<parser::Primitive>(&element.what)) {
        graph_.objects.push_back(
            {primitive, element.span, level.node, level.material, graph_.materials.size()});
      } else if (const auto* material = std::get_if<parser::Material>(&element.what)) {
        level.material = push_material(*material, level.material);
      } else if (std::holds_alternative<parser::Group>(element.what)) {
        levels.push_back({element.first_child, level.node, level.material});
      } else {
        const Mat4 local = std::visit(LocalMatrix{}, element.what);
        const Mat4 to_world = graph_.nodes[level.node].to_world * local;
        graph_.nodes.push_back({to_world});
        levels.push_back(
            {element.first_child, static_cast<std::uint32_t>(graph_.nodes.size() - 1), level.material});
      }
    }
  }

  MaterialScopeId push_material(const parser::Material& material, MaterialScopeId inherits) {
    graph_.materials.push_back({&material, inherits});
    return static_cast<MaterialScopeId>(graph_.materials.size() - 1);
  }

  const parser::Scene& description_;
  SceneGraph graph_;
  MaterialScopeId material_ = default_material;
};

}  // namespace

SceneGraph make_graph(const parser::Scene& description) {
  return GraphBuilder(description).build();
}

}  // namespace trace
