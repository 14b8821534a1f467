package lightning.scene.light;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.asset.Gobo;
import lightning.scene.asset.IesProfile;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.SceneLimits;
import lightning.scene.value.ShapeGains;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/**
 * Light with the attributes of all types; its type decides which act (paper §4.5). {@link LightAttribute} has their ranges and units.
 *
 * @param name        unique among all shapes, groups and lights
 * @param color       linear color
 * @param emission    exposure, unit and temperature, which multiply color and intensity
 * @param direction   direction in which it shines, any length
 * @param distanceFalloff how it loses strength with distance
 * @param cone        directions in which it shines
 * @param area        size of an area light
 * @param texture     image on the face of a rectangle or disc
 * @param switches    whether it shines, and its light group
 * @param illuminates shapes that it illuminates
 * @param shadowedBy  shapes that cast shadows in its light, if it casts shadows
 * @param influence its shadows and gains
 * @param flag         card that takes its light
 * @param filter       region in which it is dimmer
 */
@RecordBuilder
public record Light(String name, LightType type, Rgb color, double intensity, Emission emission, Vec3 position, Vec3 direction,
        DistanceFalloff distanceFalloff, Cone cone, AreaShape area, Optional<LightTexture> texture, Switches switches,
        ShapeLinks illuminates, ShapeLinks shadowedBy, Influence influence, LightFlag flag, LightFilter filter)
        implements LightBuilder.With {

    /** @throws IllegalArgumentException if a value is out of range; the message says which. Its records check theirs. */
    public Light {
        SceneLimits.checkName(name);
        LightAttribute.COLOR.check(color);
        LightAttribute.INTENSITY.check(intensity);
        LightAttribute.POSITION.check(position);
        LightAttribute.DIRECTION.check(direction);
    }

    /** Returns a light with initial values. */
    public static Light of(String name, LightType type) {
        return new Light(name, type, LightAttribute.COLOR.initial(), LightAttribute.INTENSITY.initial(), Emission.DEFAULT,
                LightAttribute.POSITION.initial(), LightAttribute.DIRECTION.initial(), DistanceFalloff.DEFAULT, Cone.DEFAULT,
                AreaShape.DEFAULT, Optional.empty(), Switches.DEFAULT, ShapeLinks.ALL, ShapeLinks.ALL, Influence.DEFAULT, LightFlag.NONE,
                LightFilter.NONE);
    }

    /**
     * Returns color times intensity, and of a wide directional light times {@link #wideningFactor}: of an effective light
     * ({@link LightRig#effectiveLight}), the factor of all its contributions.
     */
    public Rgb weight() {
        return color.times(intensity * wideningFactor());
    }

    /**
     * Returns the factor of a wide directional light by which a surface that faces it is as bright as under a light without width: 2/(1 +
     * cos spread), 1 for other lights. The mean cosine of directions that are uniform in a cone of this half-angle is (1 + cos spread)/2.
     */
    public double wideningFactor() {
        return type == LightType.DIRECTIONAL && isArea() ? 2 / (1 + Transform.cosDegrees(area.spread())) : 1;
    }

    /** Returns the factor of all its diffuse contributions: color times intensity and gain, limited as the intensity. */
    public Rgb diffuseWeight() {
        return color.times(limitedIntensity(influence.diffuse()));
    }

    /** Returns the factor of all its specular contributions. */
    public Rgb specularWeight() {
        return color.times(limitedIntensity(influence.specular()));
    }

    /** Returns the factor of the light that fog scatters. */
    public Rgb fogWeight() {
        return color.times(limitedIntensity(influence.fog()));
    }

    /** Returns the largest factor of a contribution to any shape. */
    public double maxWeight() {
        return color.max() * limitedIntensity(influence.maxGain() * influence.gains().max());
    }

    /** Returns the factor of all its contributions, of which {@link #relativeGain} is another: color times intensity, limited. */
    public Rgb limitedWeight() {
        return color.times(limitedIntensity(1));
    }

    /** Returns a gain as a factor of {@link #limitedWeight}: the gain itself, unless their product is limited. */
    public double relativeGain(double gain) {
        double whole = limitedIntensity(1);
        double gained = limitedIntensity(gain);
        return whole == 0 || gained == intensity * wideningFactor() * gain && whole == intensity * wideningFactor() ? gain : gained / whole;
    }

    private double limitedIntensity(double gain) {
        return Math.min(intensity * wideningFactor() * gain, maxIntensity());
    }

    /** Returns the gain of one of its {@link Influence#gains}, limited so that no contribution is larger than one without a gain may be. */
    public double limitedGain(double gain) {
        return Math.min(gain, maxIntensity() / Math.max(1, intensity * wideningFactor() * influence.maxGain()));
    }

    /** Returns the shapes that cast shadows in its light. */
    public ShapeLinks shadowCasters() {
        return influence.castsShadows() ? shadowedBy : ShapeLinks.NONE;
    }

    /** Returns this light with the shadows of another. */
    public Light withShadowsOf(Light other) {
        return withShadowedBy(other.shadowedBy).withInfluence(influence.withCastsShadows(other.influence.castsShadows()));
    }

    /** Returns the terms of its falloff with distance. */
    public Attenuation distanceTerms() {
        return distanceFalloff.terms();
    }

    /** Returns the largest falloff with distance, at least 0. */
    public double maxFalloff() {
        return falloff().max(type, area);
    }

    /** Returns the image on its face, if it has one and a face. */
    public Optional<Texture> faceImage() {
        return type.isSurface() && isArea() ? texture.map(LightTexture::image) : Optional.empty();
    }

    /** Returns the image that multiplies the light of its samples: that on its face, or the glow map of an object. */
    public Optional<Texture> sampleImage() {
        return type == LightType.OBJECT ? area.surface().flatMap(ObjectSurface::glowMap).map(TextureMap::image) : faceImage();
    }

    /** Returns a rectangle or disc light without its texture, in the texture's mean color; another light as it is. */
    Light withMeanTexture() {
        if (texture.isEmpty() || !type.isSurface()) {
            return this;
        }
        Light plain = withTexture(Optional.empty());
        Rgb mean = texture.get().image().areas().mean();
        double max = mean.max();
        return max == 0 ? plain.withIntensity(0)
                : plain.withColor(color.times(mean.times(1 / max))).withIntensity(Math.min(intensity * max, SceneLimits.MAX_INTENSITY));
    }

    /** Returns the largest factor of a contribution by its falloff with distance and the image on its face, at least 1. */
    public double maxFactor() {
        return Math.max(1, maxFalloff()) * Math.max(1, sampleImage().map(image -> image.areas().max()).orElse(1f));
    }

    /** Returns the largest effective intensity: times the largest falloff and image value it is one that any light may have. */
    double maxIntensity() {
        return SceneLimits.MAX_INTENSITY / maxFactor();
    }

    /** Returns whether its falloff with distance is 1 everywhere. */
    public boolean hasNoAttenuation() {
        return !type.hasPosition() || falloff() == Falloff.CUSTOM && attenuation().isNone();
    }

    /** Returns whether it is larger than a point and shines from all of its area, so that its shadows are soft. */
    public boolean isArea() {
        return !area.hardShadows() && switch (type) {
            case DIRECTIONAL -> area.spread() > 0;
            case POINT, SPOT, DISC -> area.radius() > 0;
            case RECT -> area.width() > 0 || area.height() > 0;
            case TUBE -> area.radius() > 0 || area.height() > 0;
            case OBJECT -> false;
        } || type == LightType.OBJECT && area.surface().isPresent();
    }

    /** Returns whether it has samples once it is placed in a scene: it is an area light, or the light of an object. */
    public boolean hasSamples() {
        return isArea() || type == LightType.OBJECT;
    }

    /** Returns whether it has a link or a gain to single shapes: illuminates some of them, is shadowed by some, or has a gain on some. */
    public boolean isLinked() {
        return !illuminates.isAll() || !shadowedBy.isAll() || !influence.gains().isNone();
    }

    /** Returns whether it has the name of any shape: it is linked, or the surface of one. */
    boolean namesShapes() {
        return isLinked() || !area.shape().isEmpty();
    }

    /** Returns this light with a shape or a group renamed in its links and gains. */
    public Light renameLinks(String oldName, String newName) {
        return mapLinks(links -> links.rename(oldName, newName), gains -> gains.rename(oldName, newName),
                shape -> shape.equals(oldName) ? newName : shape);
    }

    /** Returns this light with links and gains only of existing shapes and groups. */
    public Light retainLinks(Predicate<String> exists) {
        return mapLinks(links -> links.retain(exists), gains -> gains.retain(exists), shape -> exists.test(shape) ? shape : "");
    }

    private Light mapLinks(UnaryOperator<ShapeLinks> links, UnaryOperator<ShapeGains> gains, UnaryOperator<String> name) {
        ShapeLinks illuminated = links.apply(illuminates);
        ShapeLinks shadowing = links.apply(shadowedBy);
        ShapeGains gained = gains.apply(influence.gains());
        String shape = area.shape().isEmpty() ? "" : name.apply(area.shape());
        return illuminated == illuminates && shadowing == shadowedBy && gained == influence.gains() && shape.equals(area.shape()) ? this
                : withIlluminates(illuminated).withShadowedBy(shadowing).withInfluence(influence.withGains(gained))
                        .withArea(area.withShape(shape));
    }

    /** Returns {@link DistanceFalloff#falloff}. */
    public Falloff falloff() {
        return distanceFalloff.falloff();
    }

    /** Returns this light with another {@link DistanceFalloff#falloff}. */
    public Light withFalloff(Falloff v) {
        return withDistanceFalloff(distanceFalloff.withFalloff(v));
    }

    /** Returns {@link DistanceFalloff#attenuation}. */
    public Attenuation attenuation() {
        return distanceFalloff.attenuation();
    }

    /** Returns this light with another {@link DistanceFalloff#attenuation}. */
    public Light withAttenuation(Attenuation v) {
        return withDistanceFalloff(distanceFalloff.withAttenuation(v));
    }

    /** Returns {@link Cone#angle}. */
    public double angle() {
        return cone.angle();
    }

    /** Returns this light with another {@link Cone#angle}. */
    public Light withAngle(double v) {
        return withCone(cone.withAngle(v));
    }

    /** Returns {@link Cone#dropoff}. */
    public double dropoff() {
        return cone.dropoff();
    }

    /** Returns this light with another {@link Cone#dropoff}. */
    public Light withDropoff(double v) {
        return withCone(cone.withDropoff(v));
    }

    /** Returns {@link Cone#beam}. */
    public Beam beam() {
        return cone.beam();
    }

    /** Returns this light with another {@link Cone#beam}. */
    public Light withBeam(Beam v) {
        return withCone(cone.withBeam(v));
    }

    /** Returns {@link Cone#doors}. */
    public BarnDoors doors() {
        return cone.doors();
    }

    /** Returns this light with another {@link Cone#doors}. */
    public Light withDoors(BarnDoors v) {
        return withCone(cone.withDoors(v));
    }

    /** Returns {@link Cone#feather}. */
    public double feather() {
        return cone.feather();
    }

    /** Returns this light with another {@link Cone#feather}. */
    public Light withFeather(double v) {
        return withCone(cone.withFeather(v));
    }

    /** Returns {@link Cone#gobo}. */
    public Optional<Gobo> gobo() {
        return cone.gobo();
    }

    /** Returns this light with another {@link Cone#gobo}. */
    public Light withGobo(Optional<Gobo> v) {
        return withCone(cone.withGobo(v));
    }

    /** Returns {@link Cone#profile}. */
    public Optional<IesProfile> profile() {
        return cone.profile();
    }

    /** Returns this light with another {@link Cone#profile}. */
    public Light withProfile(Optional<IesProfile> v) {
        return withCone(cone.withProfile(v));
    }

    /** Returns {@link Switches#on}. */
    public boolean on() {
        return switches.on();
    }

    /** Returns this light with another {@link Switches#on}. */
    public Light withOn(boolean v) {
        return withSwitches(switches.withOn(v));
    }

    /** Returns {@link Switches#solo}. */
    public boolean solo() {
        return switches.solo();
    }

    /** Returns this light with another {@link Switches#solo}. */
    public Light withSolo(boolean v) {
        return withSwitches(switches.withSolo(v));
    }

    /** Returns {@link Switches#lightGroup}. */
    public String lightGroup() {
        return switches.lightGroup();
    }

    /** Returns this light with another {@link Switches#lightGroup}. */
    public Light withLightGroup(@Nullable String v) {
        return withSwitches(switches.withLightGroup(v));
    }
}
