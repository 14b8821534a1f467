package lightning.render.relight.plan;

import lightning.render.shading.layer.ConeChange;

/** Update of one light's layer, from the cheapest to the worst case (paper §4). */
public sealed interface LightUpdate {

    /** No update: the layer is current, or its light does not shine and the layer may wait. */
    record Keep() implements LightUpdate {}

    /** Only color or intensity changed: a new weight, or at accuracy ratio the intensity ratio (§4.1). */
    record Reweight() implements LightUpdate {}

    /**
     * Update of a light that does not move: unblocked shadow rays stay known.
     *
     * @param cone    rows that may enter or leave its cone (§4.3)
     * @param falloff true if attenuation or spot coefficient changed (§4.2, §4.4)
     * @param weight  true if color or intensity changed too
     * @param shadows true if other shapes cast shadows from the light
     */
    record Partial(ConeChange cone, boolean falloff, boolean weight, boolean shadows) implements LightUpdate {

        /** Creates an update with unchanged shadows. */
        public Partial(ConeChange cone, boolean falloff, boolean weight) {
            this(cone, falloff, weight, false);
        }
    }

    /** At accuracy ratio: recomputes contributions because their error bound grew too large. Casts no ray. */
    record Refresh() implements LightUpdate {}

    /** The light moved, or there is no layer yet: recomputes diffuse and specular terms in full (§4.5, §4.6). */
    record FullRecompute(boolean added) implements LightUpdate {}
}
