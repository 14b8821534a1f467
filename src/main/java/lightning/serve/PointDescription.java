package lightning.serve;

import java.util.Locale;
import lightning.base.math.Vec3;
import lightning.render.shading.LightReport;
import lightning.render.shading.PointContributions;
import lightning.render.shading.PointReport;
import lightning.render.trace.Geometry;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Material;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Report of a point and of the rays from it as JSON. Colors are linear red, green and blue. */
final class PointDescription {
    private final Geometry geometry;

    private PointDescription(Geometry geometry) {
        this.geometry = geometry;
    }

    static ObjectNode of(Geometry geometry, PointReport report) {
        return new PointDescription(geometry).describe(report, 1);
    }

    /** @param share approximate share of the pixel's color that the point contributes */
    private ObjectNode describe(PointReport report, double share) {
        ObjectNode node = JsonLines.JSON.createObjectNode();
        add(node.putArray("color"), report.color());
        if (report.isBackground()) {
            return node.put("background", true);
        }
        SurfacePoint at = report.hit();
        Material material = geometry.material(at.primitive());
        node.put("object", geometry.shape(at.primitive()).name()).put("material", material.name());
        Vec3 point = geometry.toScene(new Vec3(at.px(), at.py(), at.pz()));
        node.putArray("at").add(point.x()).add(point.y()).add(point.z());
        node.putArray("normal").add(at.nx()).add(at.ny()).add(at.nz());
        add(node.putArray("ambient"), report.ambient());
        add(node.putArray("glow"), report.glow());
        PointContributions parts = PointContributions.of(material, at);
        ArrayNode lights = node.putArray("lights");
        report.lights().forEach(light -> describe(light, parts, lights.addObject()));
        if (report.indirect() != null) {
            add(node.putArray("indirect"), parts.ofIndirect(report.indirect()));
        }
        if (report.reflected() != null) {
            describeRay(node.putObject("reflected"), report.reflected(), parts.reflectedPart(report.reflected().color()), report.color(),
                    parts, share);
        }
        if (report.refracted() != null) {
            describeRay(node.putObject("refracted"), report.refracted(), parts.refractedPart(report.refracted().color()), report.color(),
                    parts, share);
        }
        return node;
    }

    private void describeRay(ObjectNode node, PointReport ray, float[] part, float[] color, PointContributions parts, double share) {
        add(node.putArray("adds"), part);
        if (parts.shouldFollow(part, color, share)) {
            node.set("point", describe(ray, PointContributions.rayShare(part, color, share)));
        }
    }

    private void describe(LightReport light, PointContributions parts, ObjectNode node) {
        node.put("light", light.light().name()).put("state", light.state().name().toLowerCase(Locale.ROOT));
        add(node.putArray("adds"), parts.ofLight(light));
        node.put("cosine", light.cosine()).put("specular", light.specular()).put("falloff", light.falloff());
        if (light.samples() > 1) {
            node.put("samples", light.samples()).put("visible_samples", light.visibleSamples());
        }
        if (light.blocker() >= 0) {
            node.put("shadowed_by", geometry.shape(light.blocker()).name());
        }
    }

    private static void add(ArrayNode array, float[] color) {
        for (float value : color) {
            array.add(value);
        }
    }
}
