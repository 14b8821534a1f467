package lightning.render.measure;

import java.util.List;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.light.Light;
import lightning.scene.material.Material;

/** Effect whose accuracy depends on settings that {@link SettingSweep} compares. */
public enum SweptEffect {
    INDIRECT(RenderEffect.INDIRECT, SweptSetting.Gathering.all()),
    BLURRED_REFLECTIONS(RenderEffect.BLURRED_REFLECTIONS, SweptSetting.ReflectionRays.all()),
    SOFT_SHADOWS(RenderEffect.SOFT_SHADOWS, SweptSetting.LightSamples.all());

    private final RenderEffect effect;
    private final List<SweptSetting> settings;

    SweptEffect(RenderEffect effect, List<SweptSetting> settings) {
        this.effect = effect;
        this.settings = settings;
    }

    /** Returns the effect. */
    public RenderEffect effect() {
        return effect;
    }

    /** Returns the settings in order of measurement; the densest is the last. */
    public List<SweptSetting> settings() {
        return settings;
    }

    /** Returns a clause that says why a scene's settings cannot be compared; empty if they can. */
    public Optional<String> missingReason(Scene scene) {
        return switch (this) {
            case INDIRECT -> Optional.empty();
            case BLURRED_REFLECTIONS -> scene.materials().stream().anyMatch(Material::reflectsRoughly) ? Optional.empty()
                    : Optional.of(Messages.tr("no material of the scene blurs reflections"));
            case SOFT_SHADOWS -> scene.lights().stream().anyMatch(Light::isArea) ? Optional.empty()
                    : Optional.of(Messages.tr("the scene has no area light"));
        };
    }
}
