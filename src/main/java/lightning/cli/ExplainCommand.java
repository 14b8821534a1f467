package lightning.cli;

import java.util.Arrays;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import lightning.base.math.Vec3;
import lightning.base.work.Memory;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.MemoryNeed;
import lightning.render.shading.LightReport;
import lightning.render.shading.PixelExplainer;
import lightning.render.shading.PointReport;
import lightning.render.trace.Geometry;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.SurfacePoint;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.Shape;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Tells why one pixel has its colour. */
@Command(name = "explain", header = "Tell why a pixel has its colour.", abbreviateSynopsis = true,
        description = {
            "Traces one pixel: what the eye sees there, where and how it lies, and for each light whether it reaches the point",
            "(facing away, outside the cone, shadowed by a shape, lit), its cosine, specular term and falloff, and what it adds",
            "to the point's colour, with its share in percent. Where bump and normal maps or a mesh's vertices make another normal than",
            "the surface's own, each step to it is told, and which lights it faces though they are below the surface. Mirrored and refracted rays follow, indented; of those that clear",
            "surfaces send on, those that bring more than 0.2 %% of the pixel. Colours are linear red, green, blue; the last line",
            "is the pixel as the film and as the display have it, equal to render's in every bit."},
        footer = {
            "Examples:",
            "  lightning explain scenes/bird.jen 150,230",
            "  lightning explain scenes/bird.jen 960,540 --size 1920x1080"})
final class ExplainCommand implements Callable<Integer> {
    /** Of a pixel's colour; what brings less through clear surfaces is not told. */
    private static final double LEAST_SHARE = 0.002;

    private final Console console;

    @Mixin
    private SceneFile input;
    @Parameters(index = "1", paramLabel = "X,Y", converter = Pixel.Converter.class,
            description = "The pixel, counted from 0 at the upper left.")
    private Pixel pixel;
    @Mixin
    private PictureOptions picture;

    ExplainCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws Exception {
        Scene scene = picture.apply(input.read().scene());
        int width = scene.picture().width();
        int height = scene.picture().height();
        if (pixel.x() >= width || pixel.y() >= height) {
            throw new BadInput(Console.text("pixel %d,%d is outside the picture, expected 0,0 to %d,%d", pixel.x(), pixel.y(),
                    width - 1, height - 1));
        }
        var explainer = new PixelExplainer(scene);
        PointReport report = explainer.pixel(pixel.x(), pixel.y());
        console.line("pixel %d,%d of %d x %d", pixel.x(), pixel.y(), width, height);
        print(explainer, report, "", 1);
        last(scene, explainer.geometry(), report.color());
        return ExitCode.DONE;
    }

    /** The pixel: with finer samples it is the mean of several rays where it is on an edge, of which the centre's was told. */
    private void last(Scene scene, Geometry geometry, float[] center) {
        float[] c = center;
        if (scene.picture().sampling().isFine()) {
            c = mean(scene, geometry);
            if (!Arrays.equals(c, center)) {
                console.line("center: linear %s %s %s; the pixel is the mean of %s", center[0], center[1], center[2],
                        Console.count(scene.picture().sampling().perPixel(), "ray"));
            }
        }
        ViewTransform view = ViewTransform.DEFAULT;
        console.line("pixel: linear %s %s %s, displayed %d %d %d", c[0], c[1], c[2], view.encode(c[0]), view.encode(c[1]),
                view.encode(c[2]));
    }

    /** The pixel as the film has it. */
    private float[] mean(Scene scene, Geometry geometry) {
        MemoryNeed.checkFilm(scene.picture(), Memory.available());
        int x = pixel.x();
        int y = pixel.y();
        try (Workers workers = new Workers(1)) {
            Film film = new TraditionalTracer(scene, geometry)
                    .trace(workers, new int[] {y / Film.TILE * Film.tilesAlong(scene.picture().width()) + x / Film.TILE},
                            Progress.NONE)
                    .film();
            return new float[] {film.red(x, y), film.green(x, y), film.blue(x, y)};
        }
    }

    /** @param share which part of the pixel's colour the point brings, about */
    private void print(PixelExplainer explainer, PointReport report, String indent, double share) {
        if (!report.holes().isEmpty()) {
            console.line("%sthrough holes of %s", indent, report.holes().stream().map(s -> explainer.geometry().shape(s).name())
                    .collect(Collectors.joining(", ")));
        }
        if (report.isBackground()) {
            console.line("%snothing: the background, %s", indent, rgb(report.color()));
            return;
        }
        SurfacePoint at = report.at();
        var geometry = explainer.geometry();
        Shape shape = geometry.shape(at.primitive());
        Material material = geometry.material(at.primitive());
        Vec3 point = geometry.toScene(new Vec3(at.px(), at.py(), at.pz()));
        console.line("%s%s of material %s", indent, shape.name(), material.name());
        console.line("%s  at %.6g %.6g %.6g, normal %.6g %.6g %.6g", indent, point.x(), point.y(), point.z(), at.nx(), at.ny(), at.nz());
        if (report.normals() != null) {
            normals(report.normals(), indent);
        }
        double all = total(report.color());
        PointParts parts = PointParts.of(material, at);
        console.line("%s  %-12s adds %s %s", indent, "ambient", rgb(report.ambient()), share(report.ambient(), all));
        for (LightReport light : report.lights()) {
            float[] added = parts.of(light);
            console.line("%s  %-12s adds %s %s  %s", indent, light.light().name(), rgb(added), share(added, all), state(explainer, light));
        }
        if (at.behind() != null) {
            console.line("%s  the ray comes from %s; the surface mirrors %.1f %% of its light at this angle", indent,
                    at.behind().isInside() ? Console.text("inside, where its way was %.6g", at.behind().inside()) : "outside",
                    100 * parts.shared().fresnel());
        }
        float[] mirrored = report.reflected() == null ? null : parts.mirrored(report.reflected().color());
        float[] behind = report.refracted() == null ? null : parts.refracted(report.refracted().color());
        part("mirror", mirrored, all, indent);
        part("behind", behind, all, indent);
        console.line("%s  sum          is   %s", indent, rgb(report.color()));
        // From clear surfaces rays go on in two ways, again and again: hundreds for a pixel.
        double least = at.behind() == null ? 0 : LEAST_SHARE;
        if (mirrored != null && share * total(mirrored) >= least * all) {
            console.line("%s  the mirrored ray meets", indent);
            print(explainer, report.reflected(), indent + "    ", share * total(mirrored) / Math.max(all, Float.MIN_NORMAL));
        }
        if (behind != null && share * total(behind) >= least * all) {
            console.line("%s  the refracted ray meets", indent);
            print(explainer, report.refracted(), indent + "    ", share * total(behind) / Math.max(all, Float.MIN_NORMAL));
        }
    }

    private void normals(NormalSteps steps, String indent) {
        console.line("%s    the surface's own    %s", indent, normal(steps.surface()));
        if (steps.smooth() != null) {
            console.line("%s    between vertices     %s", indent, normal(steps.smooth()));
        }
        if (steps.mapped() != null) {
            console.line("%s    by bump, normal map  %s", indent, normal(steps.mapped()));
        }
        if (steps.bent()) {
            console.line("%s    bent towards the viewer, so that what is mirrored leaves the surface", indent);
        }
        if (steps.lift() > 0) {
            console.line("%s    shadows are asked from %.6g above the flat triangle", indent, steps.lift());
        }
    }

    private static String normal(Vec3 n) {
        return Console.text("%.6g %.6g %.6g", n.x(), n.y(), n.z());
    }

    private void part(String name, float[] added, double all, String indent) {
        if (added != null) {
            console.line("%s  %-12s adds %s %s", indent, name, rgb(added), share(added, all));
        }
    }

    private static String state(PixelExplainer explainer, LightReport light) {
        return switch (light.state()) {
            case DARK -> "off";
            case AWAY -> Console.text("facing away, cosine %.6g", light.cosine());
            case OUTSIDE -> Console.text("outside the cone, cosine %.6g", light.cosine());
            case UNLINKED -> Console.text("not linked, cosine %.6g", light.cosine());
            case SHADOWED -> Console.text("shadowed by %s, cosine %.6g", explainer.geometry().shape(light.blocker()).name(),
                    light.cosine()) + below(light);
            case LIT -> (light.samples() > 1 ? samples(explainer, light)
                    : Console.text("lit, cosine %.6g, specular %.6g, falloff %.6g", light.cosine(), light.specular(), light.falloff()))
                    + below(light) + through(light.tint());
        };
    }

    /** That a light which the normal faces is below the surface itself, which is then in between. */
    private static String below(LightReport light) {
        return light.below() == 0 ? "" : light.samples() == 1 ? ", from below the surface"
                : Console.text(", %d from below the surface", light.below());
    }

    /** What passes of a light through clear shapes; nothing where there are none. */
    private static String through(float[] tint) {
        return tint[0] == 1 && tint[1] == 1 && tint[2] == 1 ? "" : ", through clear shapes times " + rgb(tint);
    }

    private static String samples(PixelExplainer explainer, LightReport light) {
        String between = light.blocker() < 0 ? "" : " behind " + explainer.geometry().shape(light.blocker()).name();
        return Console.text("sees %d of %s%s, cosine · falloff %.6g, specular · falloff %.6g", light.seen(),
                Console.count(light.samples(), "sample"),
                between,
                light.cosine(), light.specular());
    }

    private static String rgb(float[] c) {
        return Console.text("%9.6f %9.6f %9.6f", c[0], c[1], c[2]);
    }

    private static String share(float[] part, double all) {
        return all == 0 ? "        " : Console.text("(%5.1f %%)", 100 * total(part) / all);
    }

    private static double total(float[] c) {
        return (double) c[0] + c[1] + c[2];
    }
}
