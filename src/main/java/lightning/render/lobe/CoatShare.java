package lightning.render.lobe;

import lightning.scene.material.Coat;

/** Share of light that a coat reflects. */
public final class CoatShare {
    private CoatShare() {}

    /**
     * Returns the share, 0…1.
     *
     * @param cosine between the normal and the view, 0…1
     */
    public static float of(Coat coat, float cosine) {
        return of(coat, (float) coat.weight(), (float) coat.roughness(), cosine);
    }

    /** Returns the share where maps give the coat another weight and roughness, 0…1 each. */
    public static float of(Coat coat, float weight, float roughness, float cosine) {
        return weight * ((float) coat.f0() * DirectionalAlbedo.ofF0(cosine, roughness) + DirectionalAlbedo.grazing(cosine, roughness));
    }
}
