package lightning.cli;

import java.util.List;
import java.util.Locale;
import lightning.base.math.Vec3;
import lightning.cli.report.ExplainReport;
import lightning.render.shading.LightReport;
import lightning.render.shading.PixelExplainer;
import lightning.render.shading.PointContributions;
import lightning.render.shading.PointReport;
import lightning.render.trace.Geometry;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Material;

/** Converts the explanation of a point, with all rays from it, to its record for {@code --json}. */
final class PointReporter {
    private final Geometry geometry;

    PointReporter(PixelExplainer explainer) {
        geometry = explainer.geometry();
    }

    ExplainReport.Point report(PointReport report) {
        List<String> holes = report.passedCutouts().stream().map(this::name).toList();
        if (report.isBackground()) {
            return new ExplainReport.Point(null, null, holes, null, null, null, null, null, null, null, null, null, report.color());
        }
        SurfacePoint at = report.hit();
        Material material = geometry.material(at.primitive());
        PointContributions parts = PointContributions.of(material, at);
        Vec3 position = geometry.toScene(new Vec3(at.px(), at.py(), at.pz()));
        double total = PointContributions.sum(report.color());
        return new ExplainReport.Point(name(at.primitive()), material.name(), holes, numbers(position),
                new double[] {at.nx(), at.ny(), at.nz()}, normals(report.normals()), report.ambient(), report.glow(),
                report.lights().stream().map(light -> light(light, parts.ofLight(light), total)).toList(),
                report.indirect() == null ? null : parts.ofIndirect(report.indirect()),
                report.reflected() == null ? null
                        : new ExplainReport.Ray(parts.reflectedPart(report.reflected().color()), report(report.reflected())),
                report.refracted() == null ? null
                        : new ExplainReport.Ray(parts.refractedPart(report.refracted().color()), report(report.refracted())),
                report.color());
    }

    private ExplainReport.LightShare light(LightReport light, float[] adds, double total) {
        return new ExplainReport.LightShare(light.light().name(), light.state().name().toLowerCase(Locale.ROOT),
                light.blocker() < 0 ? null : name(light.blocker()), light.visibleSamples(), light.samples(), light.cosine(),
                light.specular(), light.falloff(), light.tint(), light.face(), adds, 100 * PointContributions.sum(adds) / total);
    }

    private static ExplainReport.Normals normals(NormalSteps steps) {
        return steps == null ? null
                : new ExplainReport.Normals(numbers(steps.geometric()), steps.smooth() == null ? null : numbers(steps.smooth()),
                        steps.bumped() == null ? null : numbers(steps.bumped()), steps.isBent());
    }

    private String name(int primitive) {
        return geometry.shape(primitive).name();
    }

    private static double[] numbers(Vec3 v) {
        return new double[] {v.x(), v.y(), v.z()};
    }
}
