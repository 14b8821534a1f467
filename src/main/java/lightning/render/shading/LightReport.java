package lightning.render.shading;

import lightning.scene.Light;

/**
 * What one light does at one point, term by term as the lighting equation has them.
 *
 * @param light     the light
 * @param state     why it reaches the point or not
 * @param blocker   the index of the nearest shape between the point and the light; −1 if there is none or nobody looked
 * @param visibleSamples      of how many of its samples the light reaches the point
 * @param samples   how many samples it has; 1 for a point
 * @param samplesBelowSurface     how many of its samples are below the surface itself, though the normal that shades it faces them
 * @param cosine    N·L, also below 0, or where it is lit the diffuse term of a metallic material; of a light with samples the mean of the cosine times the falloff, and the next two likewise
 * @param specular  max(V·R, 0)<sup>shininess</sup>, or what F0 of a metallic material multiplies; 0 where the light does not reach
 * @param grazing   what a metallic material sends besides; 0 where the light does not reach, and of others
 * @param falloff   atten·spot; 0 where the light does not reach
 * @param diffuse   its part of Σ Idiff, linear, {@code float[3]}
 * @param highlight its part of Σ Ispec, linear, {@code float[3]}
 * @param sheen     its part of Σ Igraz, linear, {@code float[3]}
 * @param tint      what passes of it through clear shapes in between, {@code float[3]}; 1 where there are none
 */
public record LightReport(Light light, State state, int blocker, int visibleSamples, int samples, int samplesBelowSurface, float cosine,
        float specular,
        float grazing,
        float falloff,
        float[] diffuse,
        float[] highlight, float[] sheen, float[] tint) {

    /** Decided in this order, but for {@link #DARK}, which comes first. */
    public enum State {
        /** Off, silenced by a solo light, black or of intensity 0. */
        DARK,
        /** The surface faces away from it. */
        AWAY,
        /** The point is outside its cone. */
        OUTSIDE,
        /** It does not shine on the shape. */
        UNLINKED,
        /** A shape that throws a shadow in its light is in between. */
        SHADOWED,
        /** It shines on the point. */
        LIT
    }
}
