package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import java.util.Objects;
import java.util.stream.Stream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.render.fog.FogMedium;
import lightning.render.trace.HitRows;
import lightning.scene.Scene;
import lightning.scene.light.AreaShape;
import lightning.scene.light.IntensityUnit;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.jspecify.annotations.Nullable;

/**
 * Geometry of a light in render space: everything that decides which rows it reaches and with which terms, except its weight.
 *
 * @param light    the scene's light
 * @param origin   origin of render space in the scene
 * @param position the position; for a directional light the unit vector towards it
 * @param axis     the unit direction in which the light shines
 * @param cosAngle cosine of the cone's half-angle; a surface light has a half-space, and so has a sample of an object unless it shines to both sides
 * @param dropoff  exponent of the falloff from the axis; of a surface one more than its focus (Lambert's cosine)
 * @param centerSamples samples of an area light that rows of pixel centers use; null for a point light, whose only sample is its
 *     position
 * @param fog           fog that dims it on its way to a point; null if none does. A directional light is dimmed only by fog with bounds, so that
 *     its brightness is the one below the fog otherwise
 * @param fineSamples   samples that rows of finer samples use; null for a point light, and without anti-aliasing
 * @param highlightWidening what the light of one sample adds to α² of metallic highlights at distance 1; 0 for a point light
 * @param surfels the same source with the samples that surfels use; null for a point light, and in that source
 */
public record LightSource(Light light, Vec3 origin, Vec3 position, Vec3 axis, double cosAngle, double dropoff, @Nullable FogMedium fog,
        @Nullable AreaSamples centerSamples, @Nullable AreaSamples fineSamples, double highlightWidening,
        @Nullable LightSource surfels) {

    /** Returns a light's source in the camera's render space. */
    public static LightSource of(Light light, Scene scene) {
        Vec3 axis = light.direction().normalized();
        Vec3 origin = scene.camera().origin();
        Vec3 source = !light.type().hasPosition() ? axis.negated()
                : light.area().surface().map(surface -> surface.middle(origin)).orElseGet(() -> light.position().minus(origin));
        boolean surface = light.type().isSurface();
        FogMedium fog = FogMedium.of(scene);
        boolean object = light.type() == LightType.OBJECT;
        var center = new LightSource(light, origin, source, axis,
                surface ? 0 : object ? -1 : Transform.cosDegrees(light.angle()), surface ? 1 + light.dropoff() : light.dropoff(),
                fog != null && (light.type().hasPosition() || fog.hasBounds()) ? fog : null,
                light.isArea() ? AreaSamples.ofCenters(light, origin, source, axis) : null,
                light.isArea() && scene.picture().sampling().isSupersampled()
                        ? AreaSamples.ofFineSamples(light, origin, source, axis, scene.picture().sampling()) : null,
                highlightWidening(light, light.area().samples()), null);
        return light.isArea() ? center.withSurfels(AreaSamples.ofSurfels(light, origin, source, axis)) : center;
    }

    private LightSource withSurfels(AreaSamples samples) {
        return new LightSource(light, origin, position, axis, cosAngle, dropoff, fog, centerSamples, fineSamples, highlightWidening,
                new LightSource(light, origin, position, axis, cosAngle, dropoff, fog, samples, null,
                        highlightWidening(light, samples.samples()), null));
    }

    /** Returns the same source in other fog. */
    LightSource withFog(@Nullable FogMedium v) {
        return new LightSource(light, origin, position, axis, cosAngle, dropoff, v, centerSamples, fineSamples, highlightWidening,
                surfels == null ? null : surfels.withFog(v));
    }

    /** Returns the same source with the samples that surfels use instead of those of pixel centers. */
    public LightSource forSurfels() {
        return surfels == null ? this : surfels;
    }

    public LightType type() {
        return light.type();
    }

    /** Returns whether it is an area light. */
    public boolean isArea() {
        return centerSamples != null;
    }

    /** Returns whether rows may be outside its cone. */
    public boolean hasCone() {
        return type().hasCone() || type().isSurface();
    }

    /** Returns whether its falloff is not 1 everywhere. */
    public boolean hasFalloff() {
        return switch (type()) {
            case DIRECTIONAL -> AngularMask.isActive(this);
            case POINT -> !light.hasNoAttenuation() || AngularMask.isActive(this);
            case SPOT -> !light.hasNoAttenuation() || dropoff != 0 || AngularMask.isActive(this);
            case RECT, DISC, TUBE, OBJECT -> true;
        };
    }

    /** Returns whether it needs a falloff column. The terms of an area light include the falloff of each sample. */
    public boolean needsFalloffColumn() {
        return centerSamples == null && hasFalloff();
    }

    /** Returns the samples of an area light that some rows use. */
    public AreaSamples samples(HitRows rows) {
        return requireNonNull(rows.pattern == null ? centerSamples : fineSamples);
    }

    /**
     * Returns what the light of one sample adds to α² of metallic highlights at distance 1: an eighth of the area that the sample
     * stands for, in square scene units; of a directional light, of its solid angle. 0 for a point light.
     *
     * <p>A sample stands for a patch of the light. A lobe narrower than the reflection of this patch hits a sample or misses all,
     * and pixels get too much or nothing. So it is widened by the patch, as if a gaussian with half of its width blurred the facets: twice
     * the variance is added to α² (Kaplanyan and Dachsbacher, Path space regularization for holistic and robust light transport, 2013;
     * Tokuyoshi and Kaplanyan, Improved geometric specular antialiasing, 2019, which has this kernel). The facets turn by half of
     * the light's angle, hence (1/4)² · 2 = 1/8. D is normalized for any α, so the energy stays (compare Karis, Real shading in Unreal
     * Engine 4, 2013).
     *
     * <p>The n samples of a rectangle are a lattice: they also have n different places along each side. The squared distance of these places
     * is added, so that the samples of a narrow strip meet.
     *
     * @param n samples
     */
    private static double highlightWidening(Light light, double n) {
        AreaShape area = light.area();
        return !light.isArea() ? 0 : switch (light.type()) {
            case RECT -> strip(area.width(), area.height(), n);
            case OBJECT -> IntensityUnit.luminousArea(light) / n;
            case TUBE -> strip(2 * area.radius(), area.height(), n);
            case DISC, POINT, SPOT -> Math.PI * area.radius() * area.radius() / n;
            case DIRECTIONAL -> 2 * Math.PI * (1 - Transform.cosDegrees(area.spread())) / n;
        } / 8;
    }

    private static double strip(double width, double height, double n) {
        return width * height / n + (width * width + height * height) / (n * n);
    }

    /** Returns the points at which shadow rays to a light with a position end. */
    public Stream<Vec3> targets() {
        return !isArea() ? Stream.of(position)
                : allSamples().flatMap(AreaSamples::positions);
    }

    /** Returns the largest distance of any sample of an area light from its center. */
    public double extent() {
        return allSamples().mapToDouble(AreaSamples::extent).max()
                .orElseThrow();
    }

    private Stream<AreaSamples> allSamples() {
        return Stream.of(centerSamples, fineSamples, forSurfels().centerSamples).filter(Objects::nonNull).distinct();
    }

    /** Returns a sample of an area light as a light of its own; one of an object shines along its axis. */
    public LightSource at(AreaSamples samples, int pattern, int s) {
        int index = samples.index(s, pattern);
        SampleNormals normals = samples.normals();
        return new LightSource(light, origin, samples.position(pattern, s), normals == null ? axis : normals.normal(index),
                normals == null ? cosAngle : normals.bothSides()[index] ? -1 : 0, dropoff, fog, null, null, highlightWidening, null);
    }

    /** Returns whether a point is behind this sample of an object, which shines to one side only. */
    boolean isBehind(double px, double py, double pz) {
        return type() == LightType.OBJECT && cosAngle == 0
                && SampleNormals.height(px - position.x(), py - position.y(), pz - position.z(), axis.x(), axis.y(), axis.z()) < 0;
    }
}
