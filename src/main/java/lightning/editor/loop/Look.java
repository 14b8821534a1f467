package lightning.editor.loop;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.text.Texts;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;

/**
 * What of the traced picture is shown: a state of looking, no part of the scene, that saving and verifying know nothing of.
 *
 * @param light   the name of the light whose share alone is shown; empty for all of the picture
 * @param effects which effects are shown
 */
public record Look(Optional<String> light, ViewEffects effects) {
    /** The picture itself. */
    public static final Look PLAIN = new Look(Optional.empty(), ViewEffects.ALL);

    public boolean isPlain() {
        return equals(PLAIN);
    }

    public Look withLight(Optional<String> v) {
        return new Look(v, effects);
    }

    public Look withEffects(ViewEffects v) {
        return new Look(light, v);
    }

    /** What is shown, as a label of the picture: {@code Only key, no shadows}; empty for the picture itself. */
    public String label() {
        List<String> parts = new ArrayList<>();
        light.ifPresent(name -> parts.add(Texts.of("only {0}", name)));
        for (Effect effect : Effect.ALL) {
            if (!effects.shows(effect)) {
                parts.add(Texts.of("no {0}", Texts.of(effect.title())));
            }
        }
        if (!effects.litTextures()) {
            parts.add(Texts.of("glowing textures"));
        }
        String text = String.join(", ", parts);
        return text.isEmpty() ? "" : Character.toUpperCase(text.charAt(0)) + text.substring(1);
    }
}
