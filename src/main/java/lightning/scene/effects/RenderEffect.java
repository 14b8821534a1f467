package lightning.scene.effects;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.base.math.Rgb;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.light.Beam;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Falloff;
import lightning.scene.light.Influence;
import lightning.scene.light.Light;
import lightning.scene.light.LightAttribute;
import lightning.scene.light.LightFilter;
import lightning.scene.light.LightFlag;
import lightning.scene.light.LightRig;
import lightning.scene.light.LightType;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.Bulb;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import lightning.scene.material.ShadowCasting;
import lightning.scene.material.Transmission;
import lightning.scene.node.Solid;
import lightning.scene.value.Attenuation;
import lightning.scene.value.BarnDoors;
import lightning.scene.value.Fog;
import lightning.scene.value.ShapeLinks;

/** Registry of optional render effects. Each effect lists its users in a scene, and can remove itself from a scene. */
public final class RenderEffect {
    private static final List<RenderEffect> REGISTRY = new ArrayList<>();

    public static final RenderEffect SHADOWS = register("shadows", "shadows", uses -> uses.lights(_ -> true), UnaryOperator.identity());
    public static final RenderEffect SPECULAR =
            register("specular", "specular highlights", uses -> uses.litMaterials(m -> !m.specular().isBlack()),
                    scene -> EffectRemoval.mapMaterials(scene, m -> m.withSpecular(Rgb.BLACK)));
    public static final RenderEffect METALLIC = register("metallic", "metallic materials", uses -> uses.litMaterials(Material::isMetallic),
            scene -> EffectRemoval.mapMaterials(scene, m -> m.withModel(ShadingModel.PHONG)), UnaryOperator.identity(), false);
    public static final RenderEffect TEXTURES =
            register("textures", "textures", uses -> uses.litMaterials(m -> m.texture().isPresent() && !m.albedo().isBlack()),
                    scene -> EffectRemoval.mapMaterials(scene, m -> m.withTexture(Optional.empty())), EffectInjection::addWhiteTextures);
    public static final RenderEffect CUTOUTS = register("cutouts", "cutouts", uses -> uses.materials(m -> m.cutout().isActive()),
            scene -> EffectRemoval.mapMaterials(scene, m -> m.withCutout(AlphaCutout.NONE)), EffectInjection::addOpaqueCutouts);
    public static final RenderEffect BUMPS =
            register("bumps", "bump and normal maps", uses -> uses.materials(m -> !m.bumpMapping().isFlat()),
                    scene -> EffectRemoval.mapMaterials(scene, m -> m.withBumpMapping(BumpMapping.NONE)), EffectInjection::addFlatBumps);
    public static final RenderEffect VERTEX_COLORS =
            register("vertex-colors", "vertex colors", EffectUsers::vertexColors, EffectRemoval::removeVertexColors,
                    UnaryOperator.identity(), false);
    public static final RenderEffect REFLECTION =
            register("reflection", "reflections", EffectUsers::mirrors, EffectRemoval::removeReflections);
    public static final RenderEffect BLURRED_REFLECTIONS = register("blurred-reflections", "blurred reflections",
            uses -> uses.materials(Material::reflectsRoughly),
            scene -> EffectRemoval.mapMaterials(scene, m -> m.reflectsRoughly() ? m.withModel(ShadingModel.METALLIC) : m),
            UnaryOperator.identity(), false);
    public static final RenderEffect TRANSMISSION = register("clear", "transparent materials",
            uses -> uses.materials(m -> m.transmission().isTransparent() || !m.transmission().castsShadows()),
            scene -> EffectRemoval.mapMaterials(scene,
                    m -> m.withTransmission(m.transmission().isSeen() ? Transmission.NONE
                            : Transmission.NONE.withShadows(ShadowCasting.ONLY))),
            UnaryOperator.identity(), false);
    public static final RenderEffect GLOW = register("glow", "glowing materials", uses -> uses.materials(m -> !m.emission().isBlack()),
            scene -> EffectRemoval.mapMaterials(scene, m -> m.withGlow(Rgb.BLACK).withGlowMap(Optional.empty()).withBulb(Bulb.NONE)),
            UnaryOperator.identity(), false);
    public static final RenderEffect TINTED_SHADOWS =
            register("tinted-shadows", "tinted shadows", uses -> uses.materials(m -> m.transmission().tintsShadows()),
                    scene -> EffectRemoval.mapMaterials(scene, m -> m.transmission().tintsShadows()
                            ? m.withTransmission(m.transmission().withShadows(ShadowCasting.FULL)) : m),
                    UnaryOperator.identity(), false);
    public static final RenderEffect ATTENUATION =
            register("attenuation", "attenuation", uses -> uses.lights(l -> !l.hasNoAttenuation()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withFalloff(Falloff.CUSTOM).withAttenuation(Attenuation.NONE)));
    public static final RenderEffect SPOT_CONE =
            register("spot-cone", "spotlight cones", uses -> uses.lights(l -> l.type().hasCone() && l.angle() < 180),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withAngle(180)), EffectInjection::addFullCones);
    public static final RenderEffect DROPOFF =
            register("dropoff", "dropoff", uses -> uses.lights(l -> LightAttribute.DROPOFF.appliesTo(l.type()) && l.dropoff() != 0),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withDropoff(0)));
    public static final RenderEffect BARN_DOORS =
            register("barn-doors", "barn doors", uses -> uses.lights(l -> LightAttribute.DOORS.appliesTo(l.type()) && !l.doors().isOpen()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withDoors(BarnDoors.OPEN)));
    public static final RenderEffect BEAMS =
            register("beams", "beams of area lights", uses -> uses.lights(l -> l.type().isSurface() && !l.beam().isOpen()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withBeam(Beam.OPEN)));
    public static final RenderEffect GOBOS =
            register("gobos", "gobos", uses -> uses.lights(l -> LightAttribute.GOBO.appliesTo(l.type()) && l.gobo().isPresent()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withGobo(Optional.empty())));
    public static final RenderEffect FLAGS =
            register("flags", "flags", uses -> uses.lights(l -> l.flag().on()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withFlag(LightFlag.NONE)));
    public static final RenderEffect LIGHT_FILTERS =
            register("light-filters", "light filters", uses -> uses.lights(l -> l.filter().isActive()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withFilter(LightFilter.NONE)));
    public static final RenderEffect PROFILES = register("profiles", "IES profiles",
            uses -> uses.lights(l -> LightAttribute.PROFILE.appliesTo(l.type()) && l.profile().isPresent()),
            scene -> EffectRemoval.mapLights(scene, l -> l.withProfile(Optional.empty())));
    public static final RenderEffect LIGHT_TEXTURES =
            register("light-textures", "textures of lights", uses -> uses.lights(l -> l.faceImage().isPresent()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withTexture(Optional.empty())), EffectInjection::addWhiteLightTextures);
    public static final RenderEffect LIGHT_LINKS =
            register("light-links", "light linking", uses -> uses.lights(l -> !l.illuminates().isAll()),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withIlluminates(ShapeLinks.ALL)), UnaryOperator.identity(), false);
    public static final RenderEffect SHADOW_LINKS =
            register("shadow-links", "shadow linking", uses -> uses.lights(l -> !l.shadowCasters().isAll()),
                    scene -> EffectRemoval.mapLights(scene,
                            l -> l.withShadowedBy(ShapeLinks.ALL).withInfluence(l.influence().withCastsShadows(true))),
                    UnaryOperator.identity(), false);
    public static final RenderEffect LIGHT_GAINS =
            register("light-gains", "light gains", EffectUsers::gainedLights,
                    scene -> EffectRemoval.mapLights(scene, l -> l.withInfluence(
                            Influence.DEFAULT.withCastsShadows(l.influence().castsShadows()))),
                    UnaryOperator.identity(), false);
    public static final RenderEffect LIGHT_GROUPS = register("banks", "light groups", EffectUsers::lightGroups,
            scene -> scene.withRig(LightRig.of(scene.lights().stream().map(l -> l.withLightGroup("")).toList())),
            UnaryOperator.identity(), false);
    public static final RenderEffect VISIBLE_LIGHTS =
            register("visible-lights", "visible lights", uses -> uses.scene().stage().faceNames().stream(),
                    scene -> EffectRemoval.mapLights(scene, l -> l.withArea(l.area().withVisibility(FaceVisibility.HIDDEN))),
                    UnaryOperator.identity(), false);
    public static final RenderEffect SOFT_SHADOWS =
            register("soft-shadows", "soft shadows", uses -> uses.lights(Light::isArea),
                    scene -> EffectRemoval.mapLights(scene, EffectRemoval::removeArea),
                    UnaryOperator.identity(), false);
    public static final RenderEffect ANTIALIASING =
            register("antialiasing", "anti-aliasing", EffectUsers::supersampling, scene -> scene.withPicture(scene.picture()
                    .withSampling(new SamplingSettings(AntialiasMode.OFF, scene.picture().sampling().grid()))));
    public static final RenderEffect DEPTH_OF_FIELD =
            register("depth-of-field", "depth of field", EffectUsers::lens,
                    scene -> scene.withCamera(scene.camera().withLens(scene.camera().lens().withAperture(0))), UnaryOperator.identity(),
                    false);
    public static final RenderEffect ENVIRONMENT =
            register("environment", "environment", EffectUsers::environments,
                    scene -> scene.withWorld(scene.world().withoutEnvironments()), UnaryOperator.identity(), false);

    public static final RenderEffect FOG = register("fog", "fog", EffectUsers::fog,
            scene -> scene.withWorld(scene.world().withFog(Fog.NONE)), UnaryOperator.identity(), false);
    public static final RenderEffect INDIRECT = register("indirect", "indirect light", EffectUsers::indirectLight,
            Scene::withoutIndirect, UnaryOperator.identity(), false);

    /** All effects: those above, then one for each type of light and each type of solid. */
    public static final List<RenderEffect> ALL = Stream.of(REGISTRY.stream(), Arrays.stream(LightType.values()).map(RenderEffect::lights),
            Solid.CANONICAL.stream().map(RenderEffect::shapes),
            Stream.of(shapes("meshes", Solid.TriangleMesh.class))).flatMap(all -> all).toList();

    /** All effects that a document can lose; not shadows and soft shadows, because no setting of a document switches them off. */
    public static final List<RenderEffect> REMOVABLE =
            ALL.stream().filter(effect -> effect != SHADOWS && effect != SOFT_SHADOWS).toList();

    private final String id;
    private final String title;
    private final Function<EffectUsers, Stream<String>> users;
    private final UnaryOperator<Scene> removal;
    private final UnaryOperator<Scene> addition;
    private final boolean forcible;

    private RenderEffect(String id, String title, Function<EffectUsers, Stream<String>> users, UnaryOperator<Scene> removal,
            UnaryOperator<Scene> addition, boolean forcible) {
        this.id = id;
        this.title = title;
        this.users = users;
        this.removal = removal;
        this.addition = addition;
        this.forcible = forcible;
    }

    private static RenderEffect register(String id, String title, Function<EffectUsers, Stream<String>> users,
            UnaryOperator<Scene> removal) {
        return register(id, title, users, removal, UnaryOperator.identity());
    }

    private static RenderEffect register(String id, String title, Function<EffectUsers, Stream<String>> users, UnaryOperator<Scene> removal,
            UnaryOperator<Scene> addition) {
        return register(id, title, users, removal, addition, true);
    }

    private static RenderEffect register(String id, String title, Function<EffectUsers, Stream<String>> users, UnaryOperator<Scene> removal,
            UnaryOperator<Scene> addition, boolean forcible) {
        var effect = new RenderEffect(id, title, users, removal, addition, forcible);
        REGISTRY.add(effect);
        return effect;
    }

    private static RenderEffect lights(LightType type) {
        String title = switch (type) {
            case DIRECTIONAL, POINT, SPOT, DISC, TUBE, OBJECT -> type.name().toLowerCase(Locale.ROOT);
            case RECT -> "rectangular";
        } + " lights";
        return new RenderEffect(type.name().toLowerCase(Locale.ROOT) + "-lights", title, uses -> uses.lights(l -> l.type() == type),
                scene -> EffectRemoval.mapLights(scene, l -> l.type() == type ? l.withOn(false) : l), UnaryOperator.identity(), false);
    }

    private static RenderEffect shapes(Solid.Canonical solid) {
        return shapes(solid.typeName() + "s", solid.getClass());
    }

    private static RenderEffect shapes(String title, Class<? extends Solid> type) {
        return new RenderEffect(title, title, uses -> uses.shapes(type), scene -> EffectRemoval.removeShapes(scene, type),
                UnaryOperator.identity(), false);
    }

    /** Returns the effect with that {@link #id}. */
    public static RenderEffect of(String id) {
        return ALL.stream().filter(effect -> effect.id.equals(id)).findFirst().orElseThrow();
    }

    /** Returns the identifier for programs: lower case, words joined by hyphens, such as {@code barn-doors}. */
    public String id() {
        return id;
    }

    /** Returns the title for the user: lower case, in the plural if possible. */
    public String title() {
        return title;
    }

    /**
     * Returns whether its work can be forced in a scene without users; impossible for the work of a missing light, light group or shape.
     */
    public boolean isForcible() {
        return forcible;
    }

    /** Returns the names of the lights, materials or shapes that use it, in scene order, possibly repeated. */
    Stream<String> users(EffectUsers uses) {
        return users.apply(uses);
    }

    /**
     * Returns a scene that uses it with an identical image; the scene itself if there is none. Some effects can then be forced in the
     * renderer instead ({@link ViewEffects#forces}).
     */
    Scene addTo(Scene scene) {
        return addition.apply(scene);
    }

    /** Returns the scene without it; for shadows the scene itself, because no setting of a scene switches them off. */
    Scene removeFrom(Scene scene) {
        return removal.apply(scene);
    }

    @Override
    public String toString() {
        return title;
    }
}
