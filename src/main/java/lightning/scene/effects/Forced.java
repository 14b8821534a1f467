package lightning.scene.effects;

import java.util.Optional;
import lightning.scene.BarnDoors;
import lightning.scene.Cutout;
import lightning.scene.LightType;
import lightning.scene.Relief;
import lightning.scene.Scene;
import lightning.scene.Texture;
import lightning.scene.TextureMap;

/** Scenes that call for an effect and look as if they did not. */
final class Forced {
    private static final TextureMap WHITE = new TextureMap("white.png", 1, 1, new Texture(1, 1, new float[] {1, 1, 1}));

    private Forced() {}

    /** Every material without a texture has a white one: a factor of 1. */
    static Scene whiteTextures(Scene scene) {
        return Without.materials(scene, m -> m.texture().isPresent() ? m : m.withTexture(Optional.of(WHITE)));
    }

    /** Every material without a cut-out has one by which all is there. */
    static Scene wholeCutouts(Scene scene) {
        return Without.materials(scene, m -> m.cutout().cuts() ? m : m.withCutout(Cutout.NONE.withCutout(Optional.of(WHITE))));
    }

    /** Every material without a relief has one whose heights are all the same: it leaves normals as they are. */
    static Scene flatBumps(Scene scene) {
        return Without.materials(scene, m -> m.relief().isFlat() ? m.withRelief(Relief.NONE.withBump(Optional.of(WHITE))) : m);
    }

    /** Every point light without a profile is a spot light whose cone is all around, which does not drop off and has neither barn doors nor a gobo. */
    static Scene widestCones(Scene scene) {
        return Without.lights(scene, l -> l.type() == LightType.POINT && l.profile().isEmpty()
                ? l.withType(LightType.SPOT).withAngle(180).withDropoff(0).withDoors(BarnDoors.OPEN).withGobo(Optional.empty()) : l);
    }
}
