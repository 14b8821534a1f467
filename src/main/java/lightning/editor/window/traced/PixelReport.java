package lightning.editor.window.traced;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Vec3;
import lightning.base.text.Texts;
import lightning.render.shading.LightReport;
import lightning.render.shading.PointReport;
import lightning.render.trace.Geometry;

/**
 * What a pixel of the picture shows.
 *
 * @param x      columns from the left; likewise {@code y} rows from the top
 * @param shape  the shape's name; empty for the background
 * @param point  where it is in the scene; null for the background
 * @param normal of the surface there; null for the background
 * @param surface the normal of the surface itself, where another one shades it; null where none does
 * @param lights what each light does there, in the scene's order
 * @param sky    what each lamp of the environment does there
 */
record PixelReport(int x, int y, String shape, Vec3 point, Vec3 normal, Vec3 surface, List<LightReport> lights, List<LightReport> sky) {
    /** @param own how many lights the scene has without those of its environment */
    static PixelReport of(Geometry geometry, PointReport report, int own, int x, int y) {
        if (report.isBackground()) {
            return new PixelReport(x, y, "", null, null, null, List.of(), List.of());
        }
        var at = report.at();
        return new PixelReport(x, y, geometry.shape(at.primitive()).name(),
                geometry.toScene(new Vec3(at.px(), at.py(), at.pz())), new Vec3(at.nx(), at.ny(), at.nz()),
                report.normals() == null ? null : report.normals().surface(), report.lights().subList(0, own),
                report.lights().subList(own, report.lights().size()));
    }

    /** The light that brings the most to this pixel; empty where none brings anything. */
    Optional<String> strongest() {
        LightReport best = null;
        float most = 0;
        for (LightReport light : lights) {
            float share = share(light);
            if (share > most) {
                most = share;
                best = light;
            }
        }
        return Optional.ofNullable(best).map(b -> b.light().name());
    }

    private static float share(LightReport light) {
        float sum = 0;
        for (int c = 0; c < 3; c++) {
            sum += light.diffuse()[c] + light.highlight()[c] + light.sheen()[c];
        }
        return sum;
    }

    /**
     * Two lines, each as narrow as it can be: the place, the shape, its normals; the values. What is least wanted is last in its line, where
     * one that has no room is cut.
     *
     * @param values as {@link PixelValues} has them
     */
    String headline(String values) {
        String place = x + ", " + y + "  " + (shape.isEmpty() ? Texts.of("background") : shape);
        return place + (normal == null ? "" : "  " + text(Texts.key("normal %.2f %.2f %.2f"), normal)
                + (surface == null ? "" : text(Texts.key(", the surface's own %.2f %.2f %.2f"), surface)))
                + "\n" + (values.isEmpty() ? " " : values);
    }

    private static String text(String pattern, Vec3 v) {
        return String.format(Texts.locale(), Texts.of(pattern), v.x(), v.y(), v.z());
    }

    /** What each light does, as in {@code key 64 %}. */
    List<String> lightLines() {
        float total = 0;
        for (LightReport light : lights) {
            total += share(light);
        }
        float around = 0;
        for (LightReport lamp : sky) {
            around += share(lamp);
        }
        total += around;
        List<String> lines = new ArrayList<>();
        for (LightReport light : lights) {
            lines.add(light.light().name() + "  " + switch (light.state()) {
                case DARK -> Texts.of("dark");
                case AWAY -> Texts.of("facing away");
                case OUTSIDE -> Texts.of("outside the cone");
                case UNLINKED -> Texts.of("not linked");
                case SHADOWED -> light.below() == light.samples() ? Texts.of("below the surface") : Texts.of("shadowed");
                case LIT -> percent(share(light), total) + samples(light);
            });
        }
        if (!sky.isEmpty()) {
            long reaching = sky.stream().filter(lamp -> lamp.state() == LightReport.State.LIT).count();
            lines.add(Texts.of("environment  {0}, {1} of {2} lamps", percent(around, total), reaching, sky.size()));
        }
        return lines;
    }

    private static String percent(float share, float total) {
        return Math.round(100 * share / Math.max(total, Float.MIN_NORMAL)) + " %";
    }

    /** Of how many of its samples a light reaches the pixel, where that is not all of it. */
    private static String samples(LightReport light) {
        return light.seen() == light.samples() ? "" : Texts.of(", {0} of {1} samples", light.seen(), light.samples());
    }
}
