package lightning.render.shading.explanation;

import lightning.render.shading.LightWeight;
import lightning.scene.light.Light;

/**
 * Contribution of one light at one point, with every term of the lighting equation.
 *
 * @param light               the light
 * @param state               test result: the light reaches the point, or the reason why not
 * @param blocker             index of the nearest shape between the point and the light; −1 if none or not tested
 * @param visibleSamples      number of its samples that reach the point
 * @param samples             number of its samples; 1 for a point light
 * @param rays                number of shadow rays cast; none where a test before them fails
 * @param samplesBelowSurface number of its samples below the geometric surface although the shading normal faces them
 * @param cosine              N·L, also below 0; for a lit metallic material the diffuse term; for an area light the mean of the
 *                            cosine times the falloff, as for the next two
 * @param specular            max(V·R, 0)<sup>shininess</sup>, or the factor of F0 for a metallic material; 0 if the light does not
 *                            reach the point
 * @param grazing             grazing term of a metallic material; 0 for other materials or if the light does not reach the point
 * @param falloff             atten·spot; 0 if the light does not reach the point
 * @param diffuse             its part of Σ Idiff, linear, {@code float[3]}
 * @param highlight           its part of Σ Ispec, linear, {@code float[3]}
 * @param sheen               its part of Σ Igraz, linear, {@code float[3]}
 * @param tint                transmittance of clear shapes between the point and the light, {@code float[3]}; 1 if there are none
 * @param face                mean color of the light's image, weighted by the diffuse terms of its samples, {@code float[3]}; 1 if there is none
 * @param gain                gain of the light on the shape; 1 if it has none
 */
public record LightReport(Light light, State state, int blocker, int visibleSamples, int samples, int rays, int samplesBelowSurface,
        float cosine,
        float specular,
        float grazing,
        float falloff,
        float[] diffuse,
        float[] highlight, float[] sheen, float[] tint, float[] face, float gain) {

    /** Result of the tests, which run in this order except for {@link #DARK}, which comes first. */
    public enum State {
        /** Off, muted by a solo light, black or of intensity 0. */
        DARK,
        /** The surface faces away from the light. */
        AWAY,
        /** The point is outside the light's cone. */
        OUTSIDE,
        /** The light does not illuminate the shape. */
        UNLINKED,
        /** A shape that casts shadows from this light is in between. */
        SHADOWED,
        /** The light reaches the point. */
        LIT
    }

    /** Returns this report of a light with a weight, if it is that of weight 1. */
    LightReport times(LightWeight weight) {
        return new LightReport(light, state, blocker, visibleSamples, samples, rays, samplesBelowSurface, cosine, specular, grazing,
                falloff,
                times(weight, diffuse), times(weight, highlight), times(weight, sheen), tint, face, gain);
    }

    private static float[] times(LightWeight weight, float[] color) {
        return new float[] {weight.red() * color[0], weight.green() * color[1], weight.blue() * color[2]};
    }
}
