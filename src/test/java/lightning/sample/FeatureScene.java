package lightning.sample;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.FogAttributes;
import lightning.scene.Scene;
import lightning.scene.SkyAttributes;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.material.Material;
import lightning.scene.value.DomeRotation;

/** Scene with a set of features, and an edit of a light, then of a material, then of the world. */
public final class FeatureScene {
    /** Edit in both of its forms. */
    private record Edit(String assignment, UnaryOperator<Scene> direct) {}

    private static final List<Edit> LIGHT_EDITS = List.of(key("intensity=0.4", light -> light.withIntensity(0.4)),
            key("color=0.2 0.9 1", light -> light.withColor(new Rgb(0.2, 0.9, 1))),
            key("at=-2 3 1", light -> light.withPosition(new Vec3(-2, 3, 1))), key("type=spot", light -> light.withType(LightType.SPOT)));
    private static final List<Edit> MATERIAL_EDITS =
            List.of(material("paint", "ambient=0.5 0.1 0", paint -> paint.withAmbient(new Rgb(0.5, 0.1, 0))),
                    material("floor", "reflective=0.3 0.3 0.2", floor -> floor.withReflective(new Rgb(0.3, 0.3, 0.2))),
                    material("paint", "glow=0.2 0.2 0.4", paint -> paint.withGlow(new Rgb(0.2, 0.2, 0.4))),
                    material("paint", "clear=0.4 0.5 0.4",
                            paint -> paint.withTransmission(paint.transmission().withColor(new Rgb(0.4, 0.5, 0.4)))));

    private final Set<SceneFeature> features;
    private final List<String> assignments = new ArrayList<>();
    private final List<Scene> scenes = new ArrayList<>();

    /** @param turn chooses the edits */
    private FeatureScene(Set<SceneFeature> features, int turn) {
        this.features = features;
        scenes.add(SceneFeature.scene(features));
        List<Edit> worldEdits = worldEdits();
        for (Edit edit : List.of(LIGHT_EDITS.get(turn % LIGHT_EDITS.size()), MATERIAL_EDITS.get(turn % MATERIAL_EDITS.size()),
                worldEdits.get(turn % worldEdits.size()))) {
            assignments.add(edit.assignment);
            scenes.add(edit.direct.apply(scenes.getLast()));
        }
    }

    /** Returns the scenes of {@link FeatureSets#covering}. */
    public static List<FeatureScene> covering(int strength) {
        List<FeatureScene> scenes = new ArrayList<>();
        for (Set<SceneFeature> set : FeatureSets.covering(strength)) {
            scenes.add(new FeatureScene(set, scenes.size()));
        }
        return scenes;
    }

    private static Edit key(String assignment, UnaryOperator<Light> direct) {
        return new Edit("key." + assignment, scene -> scene.withLight(direct.apply(scene.light("key").orElseThrow())));
    }

    private static Edit material(String name, String assignment, UnaryOperator<Material> direct) {
        return new Edit("material:" + name + "." + assignment,
                scene -> scene.withMaterial(direct.apply(scene.material(name).orElseThrow())));
    }

    private static Edit world(String assignment, UnaryOperator<World> direct) {
        return new Edit("world." + assignment, scene -> scene.withWorld(direct.apply(scene.world())));
    }

    /** Returns edits that change this picture. */
    private List<Edit> worldEdits() {
        List<Edit> edits = new ArrayList<>();
        if (features.contains(SceneFeature.FOG)) {
            edits.add(world("fog=0.2", world -> FogAttributes.DENSITY.with(world, 0.2)));
        }
        if (features.contains(SceneFeature.SKY)) {
            edits.add(world("sky_elevation=10", world -> SkyAttributes.ELEVATION.with(world, 10.0)));
        }
        if (features.contains(SceneFeature.SKY) || features.contains(SceneFeature.ENVIRONMENT)) {
            edits.add(world("rotation=75", world -> world.withOwn(own -> own.withRotation(DomeRotation.of(75, 0, 0)))));
            edits.add(world("intensity=0.5", world -> world.withOwn(own -> own.withIntensity(0.5))));
        }
        if (features.contains(SceneFeature.DOME)) {
            edits.add(new Edit("dome:dome.intensity=2",
                    scene -> scene.withWorld(scene.world().withDome("dome", scene.world().dome("dome").orElseThrow().withIntensity(2)))));
        }
        edits.add(world("ambience=0.6", world -> world.withAmbience(0.6)));
        return edits;
    }

    /** Returns the scene before the edits, then after each. */
    public List<Scene> scenes() {
        return scenes;
    }

    /** Returns the edits as texts for {@code --set}. */
    public List<String> assignments() {
        return assignments;
    }

    @Override
    public String toString() {
        return features + " " + assignments;
    }
}
