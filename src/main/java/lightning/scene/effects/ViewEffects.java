package lightning.scene.effects;

import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import lightning.scene.Scene;

/**
 * Which effects a view shows: a state of looking, no part of the scene. The editor's preview is the
 * engine with effects taken away.
 *
 * @param hidden      effects that are not shown; without shadows every row that faces a light in its cone is lit
 * @param forced      effects for which columns are kept, loops run and rays are cast even where the scene does not call for
 *                    them: the picture is the same, only more is done; to measure what their absence saves
 * @param litTextures whether lights fall on textures; else a texture emits its own color, as the
 *                    paper's preview has it (§3.1)
 */
public record ViewEffects(Set<RenderEffect> hidden, Set<RenderEffect> forced, boolean litTextures) {
    /** Everything that the scene calls for and no more: what a picture is. */
    public static final ViewEffects ALL = new ViewEffects(Set.of(), Set.of(), true);
    /** The fast shading of the preview (paper §3.3). */
    public static final ViewEffects PREVIEW =
            new ViewEffects(Set.of(RenderEffect.SHADOWS, RenderEffect.SOFT_SHADOWS, RenderEffect.REFLECTION, RenderEffect.ANTIALIASING),
                    Set.of(), true);
    /** The same with textures that emit their colors, as the paper has it (§3.1): no light's pool can be seen on them. */
    public static final ViewEffects PREVIEW_1998 = PREVIEW.withLitTextures(false);

    public ViewEffects {
        hidden = Set.copyOf(hidden);
        forced = Set.copyOf(forced);
    }

    /** This view without these effects, and all others. */
    public ViewEffects withHidden(Collection<RenderEffect> effects) {
        return new ViewEffects(Set.copyOf(effects), forced, litTextures);
    }

    /** This view with these effects forced, and no others. */
    public ViewEffects withForced(Collection<RenderEffect> effects) {
        return new ViewEffects(hidden, Set.copyOf(effects), litTextures);
    }

    /** This view with one effect shown or hidden. */
    public ViewEffects with(RenderEffect effect, boolean shown) {
        Set<RenderEffect> hiddenEffects = new HashSet<>(hidden);
        if (shown) {
            hiddenEffects.remove(effect);
        } else {
            hiddenEffects.add(effect);
        }
        return withHidden(hiddenEffects);
    }

    public ViewEffects withLitTextures(boolean v) {
        return new ViewEffects(hidden, forced, v);
    }

    public boolean shows(RenderEffect effect) {
        return !hidden.contains(effect);
    }

    public boolean forces(RenderEffect effect) {
        return forced.contains(effect);
    }

    /** Whether the picture is that of the scene itself. */
    public boolean showsAll() {
        return hidden.isEmpty() && litTextures;
    }

    /** Whether what is known of a picture in the other view serves this one: they differ in the scenes they trace alone. */
    public boolean hasSameTrace(ViewEffects o) {
        return shows(RenderEffect.SHADOWS) == o.shows(RenderEffect.SHADOWS) && forced.equals(o.forced) && litTextures == o.litTextures;
    }

    /** The scene that this view traces: the same, or one without the hidden effects. */
    public Scene apply(Scene scene) {
        Scene result = scene;
        for (RenderEffect effect : RenderEffect.ALL) {
            result = shows(effect) ? result : effect.removeFrom(result);
            result = forces(effect) ? effect.addTo(result) : result;
        }
        return result;
    }
}
