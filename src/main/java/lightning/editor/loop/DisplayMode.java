package lightning.editor.loop;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;

/**
 * What of the traced picture is shown: a state of looking, no part of the scene, that saving and verifying know nothing of.
 *
 * @param light   the name of the light whose share alone is shown; empty for all of the picture
 * @param effects which effects are shown
 */
public record DisplayMode(Optional<String> light, ViewEffects effects) {
    /** The picture itself. */
    public static final DisplayMode FULL_PICTURE = new DisplayMode(Optional.empty(), ViewEffects.ALL);

    public boolean isFullPicture() {
        return equals(FULL_PICTURE);
    }

    public DisplayMode withLight(Optional<String> v) {
        return new DisplayMode(v, effects);
    }

    public DisplayMode withEffects(ViewEffects v) {
        return new DisplayMode(light, v);
    }

    /** What is shown, as a label of the picture: {@code Only key, no shadows}; empty for the picture itself. */
    public String label() {
        List<String> parts = new ArrayList<>();
        light.ifPresent(name -> parts.add(Messages.tr("only {0}", name)));
        for (RenderEffect effect : RenderEffect.ALL) {
            if (!effects.shows(effect)) {
                parts.add(Messages.tr("no {0}", Messages.tr(effect.title())));
            }
        }
        if (!effects.litTextures()) {
            parts.add(Messages.tr("self-illuminated textures"));
        }
        String text = String.join(", ", parts);
        return text.isEmpty() ? "" : Character.toUpperCase(text.charAt(0)) + text.substring(1);
    }
}
