package lightning.effects;

import java.util.Optional;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import lightning.math.Rgb;
import lightning.scene.Antialias;
import lightning.scene.Attenuation;
import lightning.scene.BarnDoors;
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
import lightning.scene.Solid;
import lightning.scene.SurfaceModel;

/**
 * The parts of the picture that a scene may or may not call for: the one place that names them. Each tells who calls for
 * it, and what the scene is without it.
 */
public enum Effect {
    SHADOWS("shadows", uses -> uses.lights(_ -> true), UnaryOperator.identity()),
    SPECULAR("specular highlights", uses -> uses.litMaterials(m -> !m.specular().isBlack()),
            scene -> Without.materials(scene, m -> m.withSpecular(Rgb.BLACK))),
    METALLIC("metallic materials", uses -> uses.litMaterials(Material::isMetallic),
            scene -> Without.materials(scene, m -> m.withModel(SurfaceModel.PHONG)), UnaryOperator.identity(), false),
    TEXTURES("textures", uses -> uses.litMaterials(m -> m.texture().isPresent() && !m.body().isBlack()),
            scene -> Without.materials(scene, m -> m.withTexture(Optional.empty())), Forced::whiteTextures),
    BUMPS("bump and normal maps", uses -> uses.materials(m -> !m.relief().isFlat()),
            scene -> Without.materials(scene, m -> m.withRelief(Relief.NONE)), Forced::flatBumps),
    VERTEX_COLORS("colors of vertices", Uses::tints, Without::vertexColors, UnaryOperator.identity(), false),
    REFLECTION("reflections", Uses::mirrors,
            scene -> Without.materials(scene, m -> m.withReflective(Rgb.BLACK)).withPicture(scene.picture().withDepth(0))),
    ATTENUATION("attenuation", uses -> uses.lights(l -> l.type().hasPosition() && !l.attenuation().isNone()),
            scene -> Without.lights(scene, l -> l.withAttenuation(Attenuation.NONE))),
    SPOT_CONE("cones of light", uses -> uses.lights(l -> l.type().hasCone() && l.angle() < 180),
            scene -> Without.lights(scene, l -> l.withAngle(180)), Forced::widestCones),
    DROPOFF("dropoff", uses -> uses.lights(l -> l.type().hasCone() && l.dropoff() != 0),
            scene -> Without.lights(scene, l -> l.withDropoff(0))),
    BARN_DOORS("barn doors", uses -> uses.lights(l -> LightAttribute.DOORS.acts(l.type()) && !l.doors().isOpen()),
            scene -> Without.lights(scene, l -> l.withDoors(BarnDoors.OPEN))),
    GOBOS("gobos", uses -> uses.lights(l -> l.type().hasCone() && l.gobo().isPresent()),
            scene -> Without.lights(scene, l -> l.withGobo(Optional.empty()))),
    PROFILES("profiles of lights", uses -> uses.lights(l -> LightAttribute.PROFILE.acts(l.type()) && l.profile().isPresent()),
            scene -> Without.lights(scene, l -> l.withProfile(Optional.empty()))),
    LIGHT_LINKS("links of lights to what they shine on", uses -> uses.lights(l -> !l.illuminates().isAll()),
            scene -> Without.lights(scene, l -> l.withIlluminates(Links.ALL)), UnaryOperator.identity(), false),
    SHADOW_LINKS("links of lights to what shadows them", uses -> uses.lights(l -> !l.shadowedBy().isAll()),
            scene -> Without.lights(scene, l -> l.withShadowedBy(Links.ALL)), UnaryOperator.identity(), false),
    BANKS("banks of lights", Uses::banks, scene -> scene.withRig(Rig.of(scene.lights().stream().map(l -> l.withBank("")).toList())),
            UnaryOperator.identity(), false),
    SOFT_SHADOWS("soft shadows", uses -> uses.lights(Light::isArea), scene -> Without.lights(scene, Without::area),
            UnaryOperator.identity(), false),
    ANTIALIASING("anti-aliasing", Uses::fineSamples, scene -> scene.withPicture(scene.picture()
            .withSampling(new Sampling(Antialias.OFF, scene.picture().sampling().grid())))),
    ENVIRONMENT("an environment", uses -> uses.scene().world().environment().stream().map(Panorama::file),
            scene -> scene.withWorld(scene.world().withEnvironment(Optional.empty())), UnaryOperator.identity(), false),
    DIRECTIONAL_LIGHTS("directional lights", LightType.DIRECTIONAL),
    POINT_LIGHTS("point lights", LightType.POINT),
    SPOT_LIGHTS("spot lights", LightType.SPOT),
    RECT_LIGHTS("rectangular lights", LightType.RECT),
    DISC_LIGHTS("disc lights", LightType.DISC),
    SPHERES("spheres", Solid.Sphere.class),
    CONES("cones", Solid.Cone.class),
    CYLINDERS("cylinders", Solid.Cylinder.class),
    FRUSTUMS("frustums", Solid.Frustum.class),
    PLANES("planes", Solid.Plane.class),
    MESHES("meshes", Solid.Triangles.class);

    private final String title;
    private final Function<Uses, Stream<String>> callers;
    private final UnaryOperator<Scene> without;
    private final UnaryOperator<Scene> forced;
    private final boolean forcible;

    Effect(String title, Function<Uses, Stream<String>> callers, UnaryOperator<Scene> without) {
        this(title, callers, without, UnaryOperator.identity());
    }

    Effect(String title, Function<Uses, Stream<String>> callers, UnaryOperator<Scene> without, UnaryOperator<Scene> forced) {
        this(title, callers, without, forced, true);
    }

    Effect(String title, Function<Uses, Stream<String>> callers, UnaryOperator<Scene> without, UnaryOperator<Scene> forced,
            boolean forcible) {
        this.title = title;
        this.callers = callers;
        this.without = without;
        this.forced = forced;
        this.forcible = forcible;
    }

    Effect(String title, LightType type) {
        this(title, uses -> uses.lights(l -> l.type() == type),
                scene -> Without.lights(scene, l -> l.type() == type ? l.withOn(false) : l), UnaryOperator.identity(), false);
    }

    Effect(String title, Class<? extends Solid> type) {
        this(title, uses -> uses.shapes(type), scene -> Without.shapes(scene, type), UnaryOperator.identity(), false);
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
}
