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
import lightning.scene.Antialias;
import lightning.scene.Attenuation;
import lightning.scene.BarnDoors;
import lightning.scene.Clarity;
import lightning.scene.Cutout;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.LightType;
import lightning.scene.Links;
import lightning.scene.Material;
import lightning.scene.Panorama;
import lightning.scene.Relief;
import lightning.scene.Rig;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.ShadowsThrown;
import lightning.scene.Solid;
import lightning.scene.SurfaceModel;

/**
 * The parts of the picture that a scene may or may not call for: the one place that names them. Each tells who calls for
 * it, and what the scene is without it.
 */
public final class Effect {
    private static final List<Effect> NAMED = new ArrayList<>();

    public static final Effect SHADOWS = named("shadows", "shadows", uses -> uses.lights(_ -> true), UnaryOperator.identity());
    public static final Effect SPECULAR = named("specular", "specular highlights", uses -> uses.litMaterials(m -> !m.specular().isBlack()),
            scene -> Without.materials(scene, m -> m.withSpecular(Rgb.BLACK)));
    public static final Effect METALLIC = named("metallic", "metallic materials", uses -> uses.litMaterials(Material::isMetallic),
            scene -> Without.materials(scene, m -> m.withModel(SurfaceModel.PHONG)), UnaryOperator.identity(), false);
    public static final Effect TEXTURES =
            named("textures", "textures", uses -> uses.litMaterials(m -> m.texture().isPresent() && !m.body().isBlack()),
                    scene -> Without.materials(scene, m -> m.withTexture(Optional.empty())), Forced::whiteTextures);
    public static final Effect CUTOUTS = named("cutouts", "cut-outs", uses -> uses.materials(m -> m.cutout().cuts()),
            scene -> Without.materials(scene, m -> m.withCutout(Cutout.NONE)), Forced::wholeCutouts);
    public static final Effect BUMPS = named("bumps", "bump and normal maps", uses -> uses.materials(m -> !m.relief().isFlat()),
            scene -> Without.materials(scene, m -> m.withRelief(Relief.NONE)), Forced::flatBumps);
    public static final Effect VERTEX_COLORS =
            named("vertex-colors", "colours of vertices", Uses::tints, Without::vertexColors, UnaryOperator.identity(), false);
    public static final Effect REFLECTION = named("reflection", "reflections", Uses::mirrors, Without::reflections);
    public static final Effect CLEAR = named("clear", "clear materials",
            uses -> uses.materials(m -> m.clarity().isClear() || !m.clarity().throwsShadows()),
            scene -> Without.materials(scene, m -> m.withClarity(Clarity.NONE)), UnaryOperator.identity(), false);
    public static final Effect TINTED_SHADOWS =
            named("tinted-shadows", "tinted shadows", uses -> uses.materials(m -> m.clarity().tintsLight()),
                    scene -> Without.materials(scene, m -> m.clarity().tintsLight()
                            ? m.withClarity(m.clarity().withShadows(ShadowsThrown.FULL)) : m),
                    UnaryOperator.identity(), false);
    public static final Effect ATTENUATION =
            named("attenuation", "attenuation", uses -> uses.lights(l -> l.type().hasPosition() && !l.attenuation().isNone()),
                    scene -> Without.lights(scene, l -> l.withAttenuation(Attenuation.NONE)));
    public static final Effect SPOT_CONE =
            named("spot-cone", "cones of light", uses -> uses.lights(l -> l.type().hasCone() && l.angle() < 180),
                    scene -> Without.lights(scene, l -> l.withAngle(180)), Forced::widestCones);
    public static final Effect DROPOFF = named("dropoff", "dropoff", uses -> uses.lights(l -> l.type().hasCone() && l.dropoff() != 0),
            scene -> Without.lights(scene, l -> l.withDropoff(0)));
    public static final Effect BARN_DOORS =
            named("barn-doors", "barn doors", uses -> uses.lights(l -> LightAttribute.DOORS.acts(l.type()) && !l.doors().isOpen()),
                    scene -> Without.lights(scene, l -> l.withDoors(BarnDoors.OPEN)));
    public static final Effect GOBOS = named("gobos", "gobos", uses -> uses.lights(l -> l.type().hasCone() && l.gobo().isPresent()),
            scene -> Without.lights(scene, l -> l.withGobo(Optional.empty())));
    public static final Effect PROFILES = named("profiles", "profiles of lights",
            uses -> uses.lights(l -> LightAttribute.PROFILE.acts(l.type()) && l.profile().isPresent()),
            scene -> Without.lights(scene, l -> l.withProfile(Optional.empty())));
    public static final Effect LIGHT_LINKS =
            named("light-links", "links of lights to what they shine on", uses -> uses.lights(l -> !l.illuminates().isAll()),
                    scene -> Without.lights(scene, l -> l.withIlluminates(Links.ALL)), UnaryOperator.identity(), false);
    public static final Effect SHADOW_LINKS =
            named("shadow-links", "links of lights to what shadows them", uses -> uses.lights(l -> !l.shadowedBy().isAll()),
                    scene -> Without.lights(scene, l -> l.withShadowedBy(Links.ALL)), UnaryOperator.identity(), false);
    public static final Effect BANKS = named("banks", "banks of lights", Uses::banks,
            scene -> scene.withRig(Rig.of(scene.lights().stream().map(l -> l.withBank("")).toList())),
            UnaryOperator.identity(), false);
    public static final Effect SOFT_SHADOWS =
            named("soft-shadows", "soft shadows", uses -> uses.lights(Light::isArea), scene -> Without.lights(scene, Without::area),
                    UnaryOperator.identity(), false);
    public static final Effect ANTIALIASING =
            named("antialiasing", "anti-aliasing", Uses::fineSamples, scene -> scene.withPicture(scene.picture()
                    .withSampling(new Sampling(Antialias.OFF, scene.picture().sampling().grid()))));
    public static final Effect ENVIRONMENT =
            named("environment", "an environment", uses -> uses.scene().world().environment().stream().map(Panorama::file),
                    scene -> scene.withWorld(scene.world().withEnvironment(Optional.empty())), UnaryOperator.identity(), false);

    /** Those above, then one for each type of light and each form of a shape. */
    public static final List<Effect> ALL = Stream.of(NAMED.stream(), Arrays.stream(LightType.values()).map(Effect::lights),
            Solid.CANONICAL.stream().map(Effect::shapes),
            Stream.of(shapes("meshes", Solid.Triangles.class))).flatMap(all -> all).toList();

    private final String id;
    private final String title;
    private final Function<Uses, Stream<String>> callers;
    private final UnaryOperator<Scene> without;
    private final UnaryOperator<Scene> forced;
    private final boolean forcible;

    private Effect(String id, String title, Function<Uses, Stream<String>> callers, UnaryOperator<Scene> without,
            UnaryOperator<Scene> forced, boolean forcible) {
        this.id = id;
        this.title = title;
        this.callers = callers;
        this.without = without;
        this.forced = forced;
        this.forcible = forcible;
    }

    private static Effect named(String id, String title, Function<Uses, Stream<String>> callers, UnaryOperator<Scene> without) {
        return named(id, title, callers, without, UnaryOperator.identity());
    }

    private static Effect named(String id, String title, Function<Uses, Stream<String>> callers, UnaryOperator<Scene> without,
            UnaryOperator<Scene> forced) {
        return named(id, title, callers, without, forced, true);
    }

    private static Effect named(String id, String title, Function<Uses, Stream<String>> callers, UnaryOperator<Scene> without,
            UnaryOperator<Scene> forced, boolean forcible) {
        var effect = new Effect(id, title, callers, without, forced, forcible);
        NAMED.add(effect);
        return effect;
    }

    private static Effect lights(LightType type) {
        String title = switch (type) {
            case DIRECTIONAL, POINT, SPOT, DISC -> type.name().toLowerCase(Locale.ROOT);
            case RECT -> "rectangular";
        } + " lights";
        return new Effect(type.name().toLowerCase(Locale.ROOT) + "-lights", title, uses -> uses.lights(l -> l.type() == type),
                scene -> Without.lights(scene, l -> l.type() == type ? l.withOn(false) : l), UnaryOperator.identity(), false);
    }

    private static Effect shapes(Solid.Canonical solid) {
        return shapes(solid.noun() + "s", solid.getClass());
    }

    private static Effect shapes(String title, Class<? extends Solid> type) {
        return new Effect(title, title, uses -> uses.shapes(type), scene -> Without.shapes(scene, type), UnaryOperator.identity(), false);
    }

    /** The effect of that {@link #id}. */
    public static Effect of(String id) {
        return ALL.stream().filter(effect -> effect.id.equals(id)).findFirst().orElseThrow();
    }

    /** For programs: lower case, words joined by hyphens, as in {@code barn-doors}. */
    public String id() {
        return id;
    }

    /** For people, lower case, in the plural where there is one. */
    public String title() {
        return title;
    }

    /** Whether its work can be done where nothing calls for it; that of a light, a bank or a shape which is not there cannot. */
    public boolean isForcible() {
        return forcible;
    }

    /** The names of the lights, materials or shapes that call for it, in the order of the scene, perhaps repeatedly. */
    Stream<String> callers(Uses uses) {
        return callers.apply(uses);
    }

    /**
     * A scene that calls for it and has the very same picture; the scene itself where there is none: then those who keep
     * columns and cast rays force it ({@link ViewEffects#forces}), or nobody can.
     */
    Scene forced(Scene scene) {
        return forced.apply(scene);
    }

    /** The scene without it; for shadows the scene itself, because nothing in a scene tells of them. */
    Scene without(Scene scene) {
        return without.apply(scene);
    }

    @Override
    public String toString() {
        return title;
    }
}
