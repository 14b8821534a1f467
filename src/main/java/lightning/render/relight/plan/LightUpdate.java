package lightning.render.relight.plan;

import lightning.render.shading.ConeChange;

/** What must be done to one light's layer, from the cheapest to the worst case (paper §4). */
public sealed interface LightUpdate {

    /** Nothing: the layer is as wanted, or its light does not shine and the layer may wait. */
    record Keep() implements LightUpdate {}

    /** Only color or intensity changed: a new weight, or at accuracy ratio the intensity ratio (§4.1). */
    record Reweight() implements LightUpdate {}

    /**
     * The light stays where it is: the free ways to it stay known.
     *
     * @param cone    which rows may enter or leave its cone (§4.3)
     * @param falloff whether attenuation or spot coefficient changed (§4.2, §4.4)
     * @param weight  whether color or intensity changed too
     * @param shadows whether other shapes throw shadows in its light
     */
    record Partial(ConeChange cone, boolean falloff, boolean weight, boolean shadows) implements LightUpdate {

        /** One that is shadowed by the same shapes. */
        public Partial(ConeChange cone, boolean falloff, boolean weight) {
            this(cone, falloff, weight, false);
        }
    }

    /** At accuracy ratio: contributions anew, because their error bound grew too large; no ray is cast. */
    record Refresh() implements LightUpdate {}

    /** The light moved, or there is no layer yet: the full diffuse and specular terms (§4.5, §4.6). */
    record FullRecompute(boolean added) implements LightUpdate {}
}
