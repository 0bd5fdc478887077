// All numbers of an object that a tape may have.

#include "mjforge/model/object.h"

namespace mjforge::model {
namespace {

class Taker {
 public:
  explicit Taker(tape::Links& links) : links_(links) {}

  void Take(Object& object) {
    for (Body& body : object.bodies) Take(body);
    for (Material& material : object.materials) Take(material.attributes);
    for (Texture& texture : object.textures) Take(texture.attributes);
    for (const auto& mesh : object.meshes) {
      mesh->mesh.tape = nullptr;  // its step moves the vertices themselves
      links_.Take(mesh->scale);
      Take(mesh->attributes);
    }
    for (Section& section : object.sections) Take(section.elements);
    for (Expectation& expectation : object.expectations) Take(expectation);
    for (Fitting& fitting : object.checks.fits) Take(fitting);
    links_.Take(object.bounds.aabb.min);
    links_.Take(object.bounds.aabb.max);
    links_.Take(object.bounds.top_offset);
    links_.Take(object.bounds.bottom_offset);
    links_.Take(object.bounds.horizontal_radius);
    Take(object.mass_properties);
  }

 private:
  void Take(Pose& pose) {
    links_.Take(pose.p);
    links_.Take(pose.q);
  }
  void Take(MassProperties& properties) {
    links_.Take(properties.mass);
    links_.Take(properties.p_FCm);
    links_.Take(properties.I_Cm_F);
  }
  void Take(std::vector<Attribute>& attributes) {
    for (Attribute& attribute : attributes) {
      for (Traced<double>& number : attribute.numbers) links_.Take(number);
    }
  }
  void Take(std::vector<Element>& elements) {
    for (Element& element : elements) {
      Take(element.attributes);
      Take(element.children);
    }
  }
  void Take(Fitting& fitting) {
    for (Traced<double>& side : fitting.peg) links_.Take(side);
    links_.Take(fitting.depth);
  }
  void Take(Expectation& expectation) {
    if (expectation.min) links_.Take(*expectation.min);
    if (expectation.max) links_.Take(*expectation.max);
    for (auto& [joint, numbers] : expectation.positions) {
      for (Traced<double>& number : numbers) links_.Take(number);
    }
  }
  void Take(Body& body) {
    Take(body.X_PB);
    Take(body.mass_properties);
    Take(body.attributes);
    Take(body.elements);
    for (Joint& joint : body.joints) {
      links_.Take(joint.pos);
      links_.Take(joint.axis);
      if (joint.range) links_.Take(*joint.range);
      for (Traced<double>& number : joint.start) links_.Take(number);
      Take(joint.attributes);
    }
    for (Part& part : body.parts) {
      links_.Take(part.shape.size);
      Take(part.X_BG);
      links_.Take(part.mass);
      links_.Take(part.density);
      part.solid.reset();  // its body has the sum
      Take(part.attributes);
    }
    for (Site& site : body.sites) {
      links_.Take(site.size);
      Take(site.X_BS);
      Take(site.attributes);
    }
  }

  tape::Links& links_;
};

}  // namespace

void TakeOffTape(Object& object, tape::Links& links) { Taker(links).Take(object); }

}  // namespace mjforge::model
