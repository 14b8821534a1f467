package lightning.document.loop;

import io.soabase.recordbuilder.core.RecordBuilder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.text.Messages;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;

/**
 * View state of the traced image: an isolated light and hidden effects. It is not part of the scene and does not affect saving or
 * verification.
 *
 * @param light   name of the isolated light; empty for all lights
 * @param effects effects that are shown
 */
@RecordBuilder
public record DisplayMode(Optional<String> light, ViewEffects effects) implements DisplayModeBuilder.With {
    /** Full image with all lights and effects. */
    public static final DisplayMode FULL_PICTURE = new DisplayMode(Optional.empty(), ViewEffects.ALL);

    public boolean isFullPicture() {
        return equals(FULL_PICTURE);
    }

    /** Returns a label of the view, {@code Only key, no shadows}; empty for the full image. */
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
