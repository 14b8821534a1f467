package lightning.render.relight;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rgb;
import lightning.scene.Contribution;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.SceneElement;
import lightning.scene.Stage;
import lightning.scene.World;
import lightning.scene.light.FaceVisibility;
import lightning.scene.light.Light;

/**
 * Scene whose picture is a contribution to the picture of another scene. What changes paths of rays stays, and is dark: faces of other lights,
 * bulbs, environments.
 */
public final class ContributionScene {
    private ContributionScene() {}

    /** @param light name of the light; the picture is black if no light has it */
    public static Scene of(Scene scene, String light) {
        return of(scene, new SceneElement.OfLight(light));
    }

    /** The picture is black if the contribution is off or muted by another's solo. */
    public static Scene of(Scene scene, Contribution contribution) {
        List<Light> lights = new ArrayList<>();
        for (Light light : scene.lights()) {
            // A solo light that is switched off mutes no light.
            boolean isShown = contribution.equals(Contribution.of(light));
            Light shown = isShown && scene.isActive(light) ? light : light.withOn(false);
            boolean isBlack = !isShown && light.area().visibility() != FaceVisibility.HIDDEN;
            lights.add(isBlack ? shown.withArea(light.area().withVisibility(FaceVisibility.BLACK)) : shown);
        }
        boolean isRest = contribution instanceof Contribution.OfRest;
        Stage stage = isRest ? scene.stage()
                : scene.stage().withMaterials(scene.materials().stream().map(m -> m.withGlow(Rgb.BLACK)).toList());
        World world = scene.world().withAmbience(contribution instanceof Contribution.OfAmbience ? scene.world().ambience() : 0);
        world = isRest ? world : world.withBackground(Rgb.BLACK).withFog(world.fog().withAmbient(Rgb.BLACK));
        return new Scene(scene.picture(), scene.camera(), withEnvironment(world, scene, contribution), stage,
                scene.rig().withLights(lights));
    }

    /** Returns a world with other environments dark, and this one's light off if another's solo mutes it. */
    private static World withEnvironment(World world, Scene scene, Contribution contribution) {
        World dark = world.withDomes(world.domes().stream().map(dome -> dome.withIntensity(0)).toList());
        int index = contribution.environmentIndex(scene);
        boolean isMuted = index >= 0 && !scene.rig().isEnvironmentActive(index);
        return switch (contribution) {
            case SceneElement.OfDome(String name) -> {
                Dome dome = world.domeOrOwn(name).orElseThrow();
                yield dark.withDome(name, dome.withGain(isMuted ? 0 : dome.gain()));
            }
            case SceneElement.OfLight _,Contribution.OfAmbience _,Contribution.OfRest _ -> dark;
        };
    }
}
