package lightning.layer;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;

/** Color layer of an image; all layers add up to the image. */
sealed interface Layer {
    /** Background where camera rays hit nothing. */
    record Background() implements Layer {}

    /** Ambient term of directly visible surfaces. */
    record Ambient() implements Layer {}

    /** Light that directly visible surfaces emit themselves. */
    record Emission() implements Layer {}

    /**
     * Part of the light of some lights.
     *
     * @param set    index of their set
     * @param lights the set
     */
    record OfLights(int set, LightSet lights, LightPart part) implements Layer {}

    /** Gathered light of directly visible surfaces that comes from no light, and what they reflect of it if that is blurred. */
    record Gathered() implements Layer {}

    /** Reflections, and the scene through transparent surfaces, without the light of the sets if they have layers of their own for it. */
    record Reflections() implements Layer {}

    /**
     * Returns the layers of an image, in summation order.
     *
     * @param sets    lights that share layers
     * @param mirrors whether each set has a layer of its reflections
     * @param all     true for layers of emission without glowing materials too, which are black
     */
    static List<Layer> of(Scene scene, List<LightSet> sets, boolean mirrors, boolean all) {
        List<Layer> layers = new ArrayList<>(List.of(new Background(), new Ambient()));
        if (all || scene.stage().rendered().materials().stream().anyMatch(m -> !m.emission().isBlack())) {
            layers.add(new Emission());
        }
        Optional<GatherSettings> settings = GatherSettings.of(scene);
        boolean passesLight = settings.map(s -> s.pathBounces() > 0).orElse(false);
        boolean hasFog = scene.world().fog().isPresent();
        for (int s = 0; s < sets.size(); s++) {
            LightSet set = sets.get(s);
            List<LightPart> parts = new ArrayList<>();
            if (set.indices(scene).length > 0) {
                parts.addAll(List.of(LightPart.DIFFUSE, LightPart.SPECULAR));
            }
            if (passesLight || settings.isPresent() && set.isEnvironment()) {
                parts.add(LightPart.GATHERED);
            }
            if (mirrors) {
                parts.add(LightPart.REFLECTIONS);
            }
            if (hasFog) {
                parts.add(LightPart.FOG);
            }
            for (LightPart part : parts) {
                layers.add(new OfLights(s, set, part));
            }
        }
        if (passesLight || settings.isPresent() && !scene.world().hasEnvironment()) {
            layers.add(new Gathered());
        }
        layers.add(new Reflections());
        return layers;
    }

    /** Returns whether mirrors or transparent surfaces may be in a picture. */
    static boolean canShowReflections(Scene scene, boolean all) {
        return scene.picture().depth() > 0
                && (all ? scene.materials() : scene.stage().rendered().materials()).stream().anyMatch(m -> m.isMirror() || m.isClear());
    }
}
