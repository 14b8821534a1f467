package lightning.cli;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.cli.option.PictureOptions;
import lightning.cli.option.PixelPosition;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.ExitCode;
import lightning.format.json.PixelReporter;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.gather.GatherRays;
import lightning.render.gather.GatherStructure;
import lightning.render.image.Film;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.SceneView;
import lightning.render.relight.TraceMemory;
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
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import lightning.scene.light.Influence;
import lightning.scene.material.Material;
import lightning.scene.node.Shape;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Explains the color of one pixel. */
@Command(name = "explain", header = "Explain a pixel's color.", abbreviateSynopsis = true,
        description = {
            "Traces one pixel and prints the visible surface point and, for each light, whether it reaches the point (backfacing, "
                    + "outside the cone, shadowed by an object, lit), its cosine, specular term and falloff, and its contribution to the "
                    + "point's color with its share in percent.",
            "",
            "If bump maps, normal maps or vertex normals change the normal, prints each step from the geometric normal, and which "
                    + "lights are below the horizon. Reflected and refracted rays follow, indented; rays through transparent surfaces only "
                    + "if they contribute more than 0.2 %% of the pixel.",
            "",
            "Then come the rays of the pixel's center by purpose and light. With indirect light, prints its gather points, surfels, rays and "
                    + "bytes in the whole picture, because every pixel needs them.",
            "",
            "Colors are linear red, green, blue. The last line is the pixel in the film and on the display, bit-identical to "
                    + "that of lightning render."},
        footer = {
            "Examples:",
            "  lightning explain scenes/bird.jen 150,230",
            "  lightning explain scenes/bird.jen 960,540 --size 1920x1080"})
final class ExplainCommand implements Callable<Integer> {
    private final Console console;

    @Mixin
    private SceneFile input;
    @Parameters(index = "1", paramLabel = "X,Y", converter = PixelPosition.Converter.class,
            description = "Pixel, counted from 0 at the upper left.")
    private PixelPosition pixel;
    @Mixin
    private PictureOptions picture;

    ExplainCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Scene scene = picture.apply(input.read(console).scene());
        int width = scene.picture().width();
        int height = scene.picture().height();
        if (pixel.x() >= width || pixel.y() >= height) {
            throw new BadInputException(Console.text("pixel %d,%d is outside the image, expected 0,0 to %d,%d", pixel.x(), pixel.y(),
                    width - 1, height - 1));
        }
        PixelExplainer direct = new PixelExplainer(scene);
        IndirectLight indirect = traceIndirect(scene, direct.geometry());
        PixelExplainer explainer = withFog(direct.withIndirect(indirect), scene);
        PointReport report = explainer.explainPixel(pixel.x(), pixel.y());
        console.print("pixel %d,%d of %d x %d", pixel.x(), pixel.y(), width, height);
        print(explainer, report, "", 1);
        printRays(report.rays());
        printPaths(indirect);
        float[] color = pixelColor(scene, explainer.geometry(), report.color());
        int[] displayed = SceneView.of(scene).displayed(color[0], color[1], color[2]);
        console.print("pixel: linear %s %s %s, displayed %d %d %d", color[0], color[1], color[2], displayed[0], displayed[1],
                displayed[2]);
        console.report().setResult(new PixelReporter(scene, explainer).report(pixel.x(), pixel.y(), report, color));
        return ExitCode.OK;
    }

    /** Returns the indirect light of the whole picture, which each pixel needs; null if the scene has none. */
    private static @Nullable IndirectLight traceIndirect(Scene scene, Geometry geometry) {
        if (GatherSettings.of(scene).isEmpty()) {
            return null;
        }
        TraceMemory.check(scene, HeapBudget.availableBytes());
        try (WorkerPool workers = new WorkerPool(WorkerPool.processorCount())) {
            return new TraditionalTracer(scene, geometry).traceIndirect(workers, Progress.NONE);
        }
    }

    /** Returns an explainer with the fog of the picture. */
    private static PixelExplainer withFog(PixelExplainer explainer, Scene scene) {
        try (WorkerPool workers = new WorkerPool(WorkerPool.processorCount())) {
            var tracer = new TraditionalTracer(scene, explainer.geometry());
            return explainer.withFog(tracer.traceFog(workers, Progress.NONE), tracer.traceBounceFog(workers, Progress.NONE));
        }
    }

    private void printFog(@Nullable FogReport fog, String indent) {
        if (fog != null) {
            console.print("%s  fog passes %.4g of it and adds %s", indent, fog.transmittance(), formatRgb(fog.adds()));
        }
    }

    private void printRays(RayCounts rays) {
        String lights = new TreeMap<>(rays.shadows()).entrySet().stream().map(light -> light.getKey() + " " + light.getValue())
                .collect(Collectors.joining(", ", " (", ")"));
        console.print("rays of its center: %d of the camera, %d mirrored or refracted, %s%s", rays.eye(), rays.mirrored(),
                Console.count(rays.shadow(), "shadow ray"), rays.shadows().isEmpty() ? "" : lights);
    }

    private void printPaths(@Nullable IndirectLight indirect) {
        if (indirect != null) {
            GatherStructure paths = indirect.structure();
            console.print("%s: %s, %s, %s, %s", paths.isIndirect() ? "indirect light of the picture"
                    : paths.pointCount() > 0 ? "light of the environment" : "blurred reflections",
                    Console.count(paths.pointCount(), "gather point"),
                    Console.count(paths.surfelCount(), "surfel"), Console.count(paths.rays().total(), "ray"),
                    Console.count(paths.bytes(), "byte"));
            GatherRays rays = paths.rays();
            List<String> purposes = new ArrayList<>();
            purposes.add(Console.count(rays.points(), "ray") + " of gather points");
            purposes.add(Console.count(rays.reflections(), "ray") + " of reflection points");
            rays.bounces().forEach(count -> purposes.add(Console.count(count, "ray") + " of a further bounce"));
            console.print("  %s", String.join(", ", purposes));
        }
    }

    /**
     * Returns the pixel's color in the film. With anti-aliasing, an edge pixel is the mean of several rays, of which only the center's was
     * explained: prints that.
     */
    private float[] pixelColor(Scene scene, Geometry geometry, float[] center) {
        if (!scene.picture().sampling().isSupersampled()) {
            return center;
        }
        float[] color = supersampled(scene, geometry);
        if (!Arrays.equals(color, center)) {
            console.print("center: linear %s %s %s; the pixel is the mean of %s", center[0], center[1], center[2],
                    Console.count(scene.picture().sampling().samplesPerPixel(), "ray"));
        }
        return color;
    }

    /** Returns a pixel's color from a full trace of its tile. */
    private float[] supersampled(Scene scene, Geometry geometry) {
        MemoryEstimate.checkFilm(scene.picture(), HeapBudget.availableBytes());
        int x = pixel.x();
        int y = pixel.y();
        try (WorkerPool workers = new WorkerPool(1)) {
            Film film = new TraditionalTracer(scene, geometry)
                    .trace(workers, new int[] {y / Film.TILE_SIZE * Film.tilesAlong(scene.picture().width()) + x / Film.TILE_SIZE},
                            Progress.NONE)
                    .film();
            return new float[] {film.red(x, y), film.green(x, y), film.blue(x, y)};
        }
    }

    /**
     * Prints a point and the rays from it.
     *
     * @param share approximate share of the pixel's color that the point contributes
     */
    private void print(PixelExplainer explainer, PointReport report, String indent, double share) {
        if (!report.passedCutouts().isEmpty()) {
            console.print("%sthrough cutouts of %s", indent, report.passedCutouts().stream().map(s -> explainer.geometry().shape(s).name())
                    .collect(Collectors.joining(", ")));
        }
        if (report.isBackground()) {
            console.print("%snothing: the background, %s", indent,
                    formatRgb(report.fog() == null ? report.color() : report.fog().surface()));
            printFog(report.fog(), indent);
            return;
        }
        SurfacePoint at = requireNonNull(report.hit());
        var geometry = explainer.geometry();
        Shape shape = geometry.shape(at.primitive());
        Material material = geometry.material(at.primitive());
        Vec3 point = geometry.toScene(new Vec3(at.px(), at.py(), at.pz()));
        if (geometry.isLightFace(at.primitive())) {
            console.print("%sthe face of light %s", indent, shape.name());
        } else {
            console.print("%s%s of material %s", indent, shape.name(), material.name());
        }
        console.print("%s  at %.6g %.6g %.6g, normal %.6g %.6g %.6g", indent, point.x(), point.y(), point.z(), at.nx(), at.ny(), at.nz());
        if (report.normals() != null) {
            printNormals(report.normals(), indent);
        }
        double total = PointContributions.sum(report.color());
        PointContributions parts = PointContributions.of(material, at);
        console.print("%s  %-12s adds %s %s", indent, "ambient", formatRgb(report.ambient()), formatShare(report.ambient(), total));
        if (!material.emission().isBlack()) {
            console.print("%s  %-12s adds %s %s", indent, "glow", formatRgb(report.glow()), formatShare(report.glow(), total));
        }
        for (LightReport light : report.lights()) {
            float[] added = parts.ofLight(light);
            console.print("%s  %-12s adds %s %s  %s", indent, light.light().name(), formatRgb(added), formatShare(added, total),
                    describeState(explainer, light));
        }
        printPart("indirect light", report.indirect() == null ? null : parts.ofIndirect(report.indirect()), total, indent);
        printPart("reflection", report.surroundings() == null ? null : parts.ofSurroundings(report.surroundings()), total, indent);
        if (at.backSide() != null) {
            console.print("%s  the ray comes from %s; the surface reflects %.1f %% of its light at this angle", indent,
                    at.backSide().isInside() ? Console.text("inside, path length %.6g", at.backSide().insideDistance()) : "outside",
                    100 * parts.factors().fresnel());
        }
        float[] mirrored = report.reflected() == null ? null : parts.reflectedPart(report.reflected().color());
        float[] refracted = report.refracted() == null ? null : parts.refractedPart(report.refracted().color());
        printPart("mirror", mirrored, total, indent);
        printPart("behind", refracted, total, indent);
        console.print("%s  sum          is   %s", indent,
                formatRgb(report.fog() == null ? report.color() : report.fog().surface()));
        printFog(report.fog(), indent);
        if (mirrored != null && parts.shouldFollow(mirrored, report.color(), share)) {
            console.print("%s  reflected ray hits", indent);
            print(explainer, requireNonNull(report.reflected()), indent + "    ",
                    PointContributions.rayShare(mirrored, report.color(), share));
        }
        if (refracted != null && parts.shouldFollow(refracted, report.color(), share)) {
            console.print("%s  refracted ray hits", indent);
            print(explainer, requireNonNull(report.refracted()), indent + "    ",
                    PointContributions.rayShare(refracted, report.color(), share));
        }
    }

    private void printNormals(NormalSteps steps, String indent) {
        console.print("%s    geometric            %s", indent, formatNormal(steps.geometric()));
        if (steps.smooth() != null) {
            console.print("%s    interpolated         %s", indent, formatNormal(steps.smooth()));
        }
        if (steps.bumped() != null) {
            console.print("%s    bump, normal map     %s", indent, formatNormal(steps.bumped()));
        }
        if (steps.isBent()) {
            console.print("%s    bent toward the viewer, so that reflected rays leave the surface", indent);
        }
        if (steps.lift() > 0) {
            console.print("%s    shadow rays start %.6g above the flat triangle", indent, steps.lift());
        }
    }

    private static String formatNormal(Vec3 n) {
        return Console.text("%.6g %.6g %.6g", n.x(), n.y(), n.z());
    }

    private void printPart(String name, float @Nullable [] added, double total, String indent) {
        if (added != null) {
            console.print("%s  %-12s adds %s %s", indent, name, formatRgb(added), formatShare(added, total));
        }
    }

    private static String describeState(PixelExplainer explainer, LightReport light) {
        return switch (light.state()) {
            case DARK -> "off";
            case AWAY -> Console.text("backfacing, cosine %.6g", light.cosine());
            case OUTSIDE -> Console.text("outside the cone, cosine %.6g", light.cosine());
            case UNLINKED -> Console.text("not linked, cosine %.6g", light.cosine());
            case SHADOWED -> Console.text("shadowed by %s, cosine %.6g", explainer.geometry().shape(light.blocker()).name(),
                    light.cosine()) + describeBelow(light);
            case LIT -> (light.samples() > 1 ? describeSamples(explainer, light)
                    : Console.text("lit, cosine %.6g, specular %.6g, falloff %.6g", light.cosine(), light.specular(), light.falloff()))
                    + describeBelow(light) + describeTint(light.tint()) + describeFace(light.face()) + describeGains(light);
        };
    }

    /** Describes how many samples of a light are below the geometric surface although the shading normal faces them. */
    private static String describeBelow(LightReport light) {
        return light.samplesBelowSurface() == 0 ? "" : light.samples() == 1 ? ", below the horizon"
                : Console.text(", %d below the horizon", light.samplesBelowSurface());
    }

    /** Describes a light's attenuation by transparent shapes; empty if there are none. */
    private static String describeTint(float[] tint) {
        return tint[0] == 1 && tint[1] == 1 && tint[2] == 1 ? "" : ", filtered by transparent objects: " + formatRgb(tint);
    }

    /** Describes the mean color of a light's image; empty if it has none. */
    private static String describeFace(float[] face) {
        return face[0] == 1 && face[1] == 1 && face[2] == 1 ? "" : ", color of its texture: " + formatRgb(face);
    }

    /** Describes the gains of a light that differ from 1; empty if there are none. */
    private static String describeGains(LightReport light) {
        Influence influence = light.light().influence();
        return (influence.diffuse() == 1 ? "" : Console.text(", diffuse gain %.6g", influence.diffuse()))
                + (influence.specular() == 1 ? "" : Console.text(", specular gain %.6g", influence.specular()))
                + (light.gain() == 1 ? "" : Console.text(", gain on this object %.6g", light.gain()));
    }

    private static String describeSamples(PixelExplainer explainer, LightReport light) {
        String between = light.blocker() < 0 ? "" : " behind " + explainer.geometry().shape(light.blocker()).name();
        return Console.text("%d of %s visible%s, cosine · falloff %.6g, specular · falloff %.6g", light.visibleSamples(),
                Console.count(light.samples(), "sample"),
                between,
                light.cosine(), light.specular());
    }

    private static String formatRgb(float[] c) {
        return Console.text("%9.6f %9.6f %9.6f", c[0], c[1], c[2]);
    }

    private static String formatShare(float[] part, double total) {
        return total == 0 ? "        " : Console.text("(%5.1f %%)", 100 * PointContributions.sum(part) / total);
    }
}
