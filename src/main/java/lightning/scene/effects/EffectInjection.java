package lightning.scene.effects;

import java.util.Optional;
import lightning.scene.AlphaCutout;
import lightning.scene.BarnDoors;
import lightning.scene.BumpMapping;
import lightning.scene.LightType;
import lightning.scene.Scene;
import lightning.scene.Texture;
import lightning.scene.TextureMap;

/** Scenes that call for an effect and look as if they did not. */
final class EffectInjection {
    private static final TextureMap WHITE = new TextureMap("white.png", 1, 1, new Texture(1, 1, new float[] {1, 1, 1}));

    private EffectInjection() {}

    /** Every material without a texture has a white one: a factor of 1. */
    static Scene addWhiteTextures(Scene scene) {
        return EffectRemoval.mapMaterials(scene, m -> m.texture().isPresent() ? m : m.withTexture(Optional.of(WHITE)));
    }

    /** Every material without a cut-out has one by which all is there. */
    static Scene addOpaqueCutouts(Scene scene) {
        return EffectRemoval.mapMaterials(scene,
                m -> m.cutout().isActive() ? m : m.withCutout(AlphaCutout.NONE.withMap(Optional.of(WHITE))));
    }

    /** Every material without a relief has one whose heights are all the same: it leaves normals as they are. */
    static Scene addFlatBumps(Scene scene) {
        return EffectRemoval.mapMaterials(scene,
                m -> m.bumpMapping().isFlat() ? m.withBumpMapping(BumpMapping.NONE.withBump(Optional.of(WHITE))) : m);
    }

    /** Every point light without a profile is a spot light whose cone is all around, which does not drop off and has neither barn doors nor a gobo. */
    static Scene addFullCones(Scene scene) {
        return EffectRemoval.mapLights(scene, l -> l.type() == LightType.POINT && l.profile().isEmpty()
                ? l.withType(LightType.SPOT).withAngle(180).withDropoff(0).withDoors(BarnDoors.OPEN).withGobo(Optional.empty()) : l);
    }
}
