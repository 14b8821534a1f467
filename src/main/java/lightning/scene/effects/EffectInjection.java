package lightning.scene.effects;

import java.util.Optional;
import lightning.scene.Scene;
import lightning.scene.asset.LightTexture;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.light.LightType;
import lightning.scene.material.AlphaCutout;
import lightning.scene.material.BumpMapping;
import lightning.scene.value.BarnDoors;

/** Scenes that use an effect without changing the image. */
final class EffectInjection {
    private static final TextureMap WHITE = new TextureMap("white.png", 1, 1, new Texture(1, 1, new float[] {1, 1, 1}));

    private EffectInjection() {}

    /** Gives every material without a texture a white one. */
    static Scene addWhiteTextures(Scene scene) {
        return EffectRemoval.mapMaterials(scene, m -> m.texture().isPresent() ? m : m.withTexture(Optional.of(WHITE)));
    }

    /** Gives every material without a cutout a fully opaque one. */
    static Scene addOpaqueCutouts(Scene scene) {
        return EffectRemoval.mapMaterials(scene,
                m -> m.cutout().isActive() ? m : m.withCutout(AlphaCutout.NONE.withMap(Optional.of(WHITE))));
    }

    /** Gives every material without a bump map one of constant height. */
    static Scene addFlatBumps(Scene scene) {
        return EffectRemoval.mapMaterials(scene,
                m -> m.bumpMapping().isFlat() ? m.withBumpMapping(BumpMapping.NONE.withBump(Optional.of(WHITE))) : m);
    }

    /** Gives every rectangle and disc light without a texture a white one. */
    static Scene addWhiteLightTextures(Scene scene) {
        return EffectRemoval.mapLights(scene, l -> l.type().isSurface() && l.texture().isEmpty()
                ? l.withTexture(Optional.of(new LightTexture(WHITE.file(), WHITE.image()))) : l);
    }

    /** Makes every point light without a profile a spot light with a full cone, no dropoff, open barn doors and no gobo. */
    static Scene addFullCones(Scene scene) {
        return EffectRemoval.mapLights(scene, l -> l.type() == LightType.POINT && l.profile().isEmpty()
                ? l.withType(LightType.SPOT).withAngle(180).withDropoff(0).withDoors(BarnDoors.OPEN).withGobo(Optional.empty()) : l);
    }
}
