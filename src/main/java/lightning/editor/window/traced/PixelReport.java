package lightning.editor.window.traced;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.base.math.Vec3;
import lightning.base.text.Messages;
import lightning.render.relight.LightThumbnails;
import lightning.render.shading.explanation.LightReport;
import lightning.render.shading.explanation.PointReport;
import lightning.render.trace.Geometry;
import lightning.scene.light.Light;
import lightning.scene.value.ShapeGains;
import org.jspecify.annotations.Nullable;

/**
 * Report on a pixel of the picture.
 *
 * @param x column from the left
 * @param y row from the top
 * @param shape name of the shape; empty for the background and for the face of a light
 * @param face name of the light whose face the pixel shows; empty for none
 * @param point position in the scene; null for the background
 * @param normal shading normal; null for the background
 * @param geometricNormal geometric normal if it differs from the shading normal; otherwise null
 * @param lights contribution of each light, in the scene's order
 * @param environmentLights contribution of each environment sample
 * @param indirect indirect light: red, green, blue; null if there is none
 */
record PixelReport(int x, int y, String shape, String face, @Nullable Vec3 point, @Nullable Vec3 normal, @Nullable Vec3 geometricNormal,
        List<LightReport> lights, List<LightReport> environmentLights, float @Nullable [] indirect) {
    /**
     * Creates a report.
     *
     * @param lightCount number of lights in the scene, without environment lights
     */
    static PixelReport of(Geometry geometry, PointReport report, int lightCount, int x, int y) {
        if (report.isBackground()) {
            return new PixelReport(x, y, "", "", null, null, null, List.of(), List.of(), null);
        }
        var hit = report.hit();
        String name = geometry.shape(requireNonNull(hit).primitive()).name();
        boolean isFace = geometry.isLightFace(hit.primitive());
        return new PixelReport(x, y, isFace ? "" : name, isFace ? name : "",
                geometry.toScene(new Vec3(hit.px(), hit.py(), hit.pz())), new Vec3(hit.nx(), hit.ny(), hit.nz()),
                report.normals() == null ? null : report.normals().geometric(), report.lights().subList(0, lightCount),
                report.lights().subList(lightCount, report.lights().size()), report.indirect());
    }

    /** Returns the light that contributes most to this pixel, or whose face it shows; empty if there is none. */
    Optional<String> strongest() {
        return !face.isEmpty() ? Optional.of(face)
                : contributions().stream().filter(c -> c.brightness() > 0).max(Comparator.comparingDouble(LightShare::brightness))
                        .map(c -> c.light().name());
    }

    private static double brightness(LightReport light) {
        return luminance(light.diffuse()) + luminance(light.highlight()) + luminance(light.sheen());
    }

    /** Returns the luminance of linear red, green and blue, as in the light mixer and in the report of light contributions. */
    private static double luminance(float[] rgb) {
        return LightThumbnails.brightness(rgb);
    }

    /**
     * Returns two short lines: the position, shape and normals, and the values. The least important part of a line is last, because a
     * narrow window truncates it.
     *
     * @param values text from {@link PixelValues}
     */
    String headline(String values) {
        String position = x + ", " + y + "  "
                + (!face.isEmpty() ? Messages.tr("light {0}", face) : shape.isEmpty() ? Messages.tr("background") : shape);
        return position + (normal == null ? "" : "  " + text(Messages.key("normal %.2f %.2f %.2f"), normal)
                + (geometricNormal == null ? "" : text(Messages.key(", geometric normal %.2f %.2f %.2f"), geometricNormal)))
                + "\n" + (values.isEmpty() ? " " : values);
    }

    private static String text(String pattern, Vec3 v) {
        return String.format(Messages.locale(), Messages.tr(pattern), v.x(), v.y(), v.z());
    }

    /**
     * LightShare of a light to this pixel.
     *
     * @param light the light
     * @param brightness its luminance here; 0 if it does not reach the point
     * @param text share of the light here, or why there is none: {@code 64 %}, {@code shadowed}
     */
    record LightShare(Light light, double brightness, String text) {}

    /** Returns the contribution of each light, in the scene's order. */
    List<LightShare> contributions() {
        double total = totalBrightness();
        return lights.stream().map(light -> new LightShare(light.light(), brightness(light), switch (light.state()) {
            case DARK -> Messages.tr("dark");
            case AWAY -> Messages.tr("backfacing");
            case OUTSIDE -> Messages.tr("outside the cone");
            case UNLINKED -> Messages.tr("not linked");
            case SHADOWED -> light.samplesBelowSurface() == light.samples() ? Messages.tr("below the horizon") : Messages.tr("shadowed");
            case LIT -> percent(brightness(light), total) + samplesText(light) + gainText(light);
        })).toList();
    }

    /** Returns the shares of the environment and of indirect light, each only if the scene has it. */
    List<String> otherLines() {
        double total = totalBrightness();
        List<String> lines = new ArrayList<>();
        if (!environmentLights.isEmpty()) {
            long litCount =
                    environmentLights.stream().filter(environmentLight -> environmentLight.state() == LightReport.State.LIT).count();
            lines.add(Messages.tr("environment  {0}, {1} of its {2} bright parts are visible", percent(environmentBrightness(), total),
                    litCount,
                    environmentLights.size()));
        }
        if (indirect != null) {
            lines.add(Messages.tr("indirect light  {0}", percent(luminance(indirect), total)));
        }
        return lines;
    }

    /** Returns the contribution of each light, such as {@code key 64 %}, then those of {@link #otherLines}. */
    List<String> lightLines() {
        return Stream.concat(contributions().stream().map(c -> c.light().name() + "  " + c.text()), otherLines().stream()).toList();
    }

    private double environmentBrightness() {
        return environmentLights.stream().mapToDouble(PixelReport::brightness).sum();
    }

    private double totalBrightness() {
        return lights.stream().mapToDouble(PixelReport::brightness).sum() + environmentBrightness()
                + (indirect == null ? 0 : luminance(indirect));
    }

    private static String percent(double share, double total) {
        return Math.round(100 * share / Math.max(total, Float.MIN_NORMAL)) + " %";
    }

    /** Returns the gain of a light on the object; empty for 1. */
    private static String gainText(LightReport light) {
        return light.gain() == 1 ? "" : Messages.tr(", gain {0}", ShapeGains.formatPercent(light.gain()));
    }

    /** Returns how many of a light's points are visible; empty if all are. */
    private static String samplesText(LightReport light) {
        return light.visibleSamples() == light.samples() ? ""
                : Messages.tr(", {0} of its {1} points are visible", light.visibleSamples(), light.samples());
    }
}
