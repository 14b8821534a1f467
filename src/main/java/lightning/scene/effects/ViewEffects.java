package lightning.scene.effects;

import java.util.Collection;
import java.util.HashSet;
import java.util.Set;
import lightning.scene.Scene;

/**
 * Effects shown in a view; not part of the scene. The editor's preview is the renderer with some effects hidden.
 *
 * @param hidden      hidden effects; without shadows every row that faces a light within its cone is lit
 * @param forced      effects whose columns, loops and rays are computed even if the scene does not use them. The image is the same;
 *     measures the benefit of skipping unused effects
 * @param litTextures true if lights affect textures; otherwise a texture emits its own color, as in the paper's preview (§3.1)
 */
public record ViewEffects(Set<RenderEffect> hidden, Set<RenderEffect> forced, boolean litTextures) {
    /** All effects of the scene, as in a final image. */
    public static final ViewEffects ALL = new ViewEffects(Set.of(), Set.of(), true);
    /** Fast shading of the preview (paper §3.3). */
    public static final ViewEffects PREVIEW =
            new ViewEffects(Set.of(RenderEffect.SHADOWS, RenderEffect.SOFT_SHADOWS, RenderEffect.REFLECTION, RenderEffect.ANTIALIASING,
                    RenderEffect.INDIRECT), Set.of(), true);
    /** Preview with emissive textures as in the paper (§3.1): lights are not visible on them. */
    public static final ViewEffects PREVIEW_1998 = PREVIEW.withLitTextures(false);

    public ViewEffects {
        hidden = Set.copyOf(hidden);
        forced = Set.copyOf(forced);
    }

    /** Returns this view with these effects hidden, and no others. */
    public ViewEffects withHidden(Collection<RenderEffect> effects) {
        return new ViewEffects(Set.copyOf(effects), forced, litTextures);
    }

    /** Returns this view with these effects forced, and no others. */
    public ViewEffects withForced(Collection<RenderEffect> effects) {
        return new ViewEffects(hidden, Set.copyOf(effects), litTextures);
    }

    /** Returns this view with one effect shown or hidden. */
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

    /** Returns whether it shows the final image. */
    public boolean showsAll() {
        return hidden.isEmpty() && litTextures;
    }

    /** Returns whether this view can reuse the other's cache: they differ only in the scenes that they trace. */
    public boolean hasSameTrace(ViewEffects o) {
        return shows(RenderEffect.SHADOWS) == o.shows(RenderEffect.SHADOWS) && forced.equals(o.forced) && litTextures == o.litTextures;
    }

    /** Returns the scene that this view traces, without the hidden effects. */
    public Scene apply(Scene scene) {
        Scene result = scene;
        for (RenderEffect effect : RenderEffect.ALL) {
            result = shows(effect) ? result : effect.removeFrom(result);
            result = forces(effect) ? effect.addTo(result) : result;
        }
        return result;
    }
}
