package lightning.format.json;

import static java.util.Objects.requireNonNull;

import java.util.List;
import java.util.Locale;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import lightning.base.math.Vec3;
import lightning.render.gather.GatherStructure;
import lightning.render.relight.SceneView;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RayCounts;
import lightning.render.shading.explanation.FogReport;
import lightning.render.shading.explanation.LightReport;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.render.shading.explanation.PointContributions;
import lightning.render.shading.explanation.PointReport;
import lightning.render.trace.Geometry;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.SurfacePoint;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Converts explanations of pixels to their record. */
public final class PixelReporter {
    private final Scene scene;
    private final Geometry geometry;
    private final @Nullable IndirectLight indirect;

    /** @param explainer explainer of the scene, with its indirect light */
    public PixelReporter(Scene scene, PixelExplainer explainer) {
        this.scene = scene;
        geometry = explainer.geometry();
        indirect = explainer.indirect();
    }

    /**
     * Converts the explanation of a pixel.
     *
     * @param center explanation of the ray through the pixel's center
     * @param color  the pixel in the film, linear, {@code float[3]}
     */
    public ExplainReport report(int x, int y, PointReport center, float[] color) {
        PictureSettings picture = scene.picture();
        return new ExplainReport(x, y, picture.width(), picture.height(), point(center, 1), rays(center.rays()),
                paths(),
                picture.sampling().isSupersampled() ? picture.sampling().samplesPerPixel() : 1, color,
                SceneView.of(scene).displayed(color[0], color[1], color[2]));
    }

    private static ExplainReport.Rays rays(RayCounts rays) {
        return new ExplainReport.Rays(rays.eye(), rays.mirrored(), rays.shadow(), new TreeMap<>(rays.shadows()));
    }

    private ExplainReport.@Nullable Indirect paths() {
        if (indirect == null) {
            return null;
        }
        GatherStructure paths = indirect.structure();
        return new ExplainReport.Indirect(paths.pointCount(), paths.surfelCount(), paths.rays().total(), paths.bytes());
    }

    /** @param share approximate share of the pixel's color that the point contributes */
    private ExplainReport.Point point(PointReport report, double share) {
        List<String> holes = report.passedCutouts().stream().map(this::name).toList();
        if (report.isBackground()) {
            return new ExplainReport.Point(null, null, holes, null, null, null, null, null, null, null, null, null, null, report.color(),
                    fog(report.fog()));
        }
        SurfacePoint at = requireNonNull(report.hit());
        Material material = geometry.material(at.primitive());
        PointContributions parts = PointContributions.of(material, at);
        Vec3 position = geometry.toScene(new Vec3(at.px(), at.py(), at.pz()));
        double total = PointContributions.sum(report.color());
        return new ExplainReport.Point(name(at.primitive()), material.name(), holes, numbers(position),
                new double[] {at.nx(), at.ny(), at.nz()}, normals(report.normals()), report.ambient(), report.glow(),
                report.lights().stream().map(light -> light(light, parts.ofLight(light), total)).toList(),
                report.indirect() == null ? null : parts.ofIndirect(report.indirect()),
                report.surroundings() == null ? null : parts.ofSurroundings(report.surroundings()),
                ray(report.reflected(), parts::reflectedPart, report, parts, share),
                ray(report.refracted(), parts::refractedPart, report, parts, share),
                report.color(), fog(report.fog()));
    }

    private static ExplainReport.@Nullable Fog fog(@Nullable FogReport fog) {
        return fog == null ? null : new ExplainReport.Fog(fog.transmittance(), fog.adds());
    }

    /** @param from the point that the ray starts from; {@code share} is its share of the pixel */
    private ExplainReport.@Nullable Ray ray(@Nullable PointReport ray, UnaryOperator<float[]> weigh, PointReport from,
            PointContributions parts, double share) {
        if (ray == null) {
            return null;
        }
        float[] adds = weigh.apply(ray.color());
        return new ExplainReport.Ray(adds, parts.shouldFollow(adds, from.color(), share)
                ? point(ray, PointContributions.rayShare(adds, from.color(), share)) : null);
    }

    private ExplainReport.LightShare light(LightReport light, float[] adds, double total) {
        return new ExplainReport.LightShare(light.light().name(), light.state().name().toLowerCase(Locale.ROOT),
                light.blocker() < 0 ? null : name(light.blocker()), light.visibleSamples(), light.samples(), light.cosine(),
                light.specular(), light.falloff(), light.tint(), light.face(), adds, 100 * PointContributions.sum(adds) / total);
    }

    private static ExplainReport.@Nullable Normals normals(@Nullable NormalSteps steps) {
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
