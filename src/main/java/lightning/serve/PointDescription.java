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
    /** Smallest share of a pixel's color for which rays through transparent surfaces are described: they branch. */
    private static final double MIN_SHARE = 0.002;

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
        // Transparent surfaces split rays in two, recursively: hundreds for a pixel.
        double minimum = at.backSide() == null ? 0 : MIN_SHARE;
        if (report.reflected() != null) {
            describeRay(node, "reflected", report.reflected(), parts.reflectedPart(report.reflected().color()), report.color(), share,
                    minimum);
        }
        if (report.refracted() != null) {
            describeRay(node, "refracted", report.refracted(), parts.refractedPart(report.refracted().color()), report.color(), share,
                    minimum);
        }
        return node;
    }

    private void describeRay(ObjectNode node, String name, PointReport ray, float[] part, float[] color, double share, double minimum) {
        ObjectNode child = node.putObject(name);
        add(child.putArray("adds"), part);
        double partShare = share * sum(part);
        if (partShare >= minimum * sum(color)) {
            child.set("point", describe(ray, partShare / Math.max(sum(color), Float.MIN_NORMAL)));
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

    private static double sum(float[] color) {
        return (double) color[0] + color[1] + color[2];
    }
}
