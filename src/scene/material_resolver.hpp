// Inheritance and names of materials: from what the file says to complete materials.
#pragma once

#include <map>
#include <string>

#include "scene/dialect_rules.hpp"
#include "scene/graph.hpp"
#include "scene/texture_cache.hpp"

namespace trace {

class MaterialResolver {
 public:
  MaterialResolver(TextureCache& textures, parser::Diagnostics& diagnostics, const DialectRules& rules = {})
      : textures_(textures), diagnostics_(diagnostics), rules_(rules) {}

  // A block on top of what it inherits, or the complete material a name stands for. Call in file order: a
  // block with a name registers its result for those that follow.
  MappedMaterial resolve(const parser::Material& material, const MappedMaterial& inherited);

  // A material with more assigned on top, in order.
  MappedMaterial with(const MappedMaterial& material,
                      const std::vector<parser::MaterialAssignment>& assignments);

 private:
  bool assign_extra(MappedMaterial& result, const parser::MaterialAssignment& assignment);
  // Maps that turn the surface; false for any other parameter.
  bool assign_surface_map(MappedMaterial& result, const parser::MaterialAssignment& assignment);
  void assign(MappedMaterial& result, const parser::MaterialAssignment& assignment);

  TextureCache& textures_;
  parser::Diagnostics& diagnostics_;
  DialectRules rules_;
  std::map<std::string, MappedMaterial> named_;
};

}  // namespace trace
