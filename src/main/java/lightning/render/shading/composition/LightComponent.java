package lightning.render.shading.composition;

/** Component of the light that the rows of a level show. */
public enum LightComponent {
    /** Lights' diffuse component. */
    DIFFUSE,
    /** Lights' specular and grazing component. */
    SPECULAR,
    /** Gathered light, and what blurred reflections show of it. */
    GATHERED,
    /** Mirrored and refracted rays. */
    BOUNCED,
    /** Light that surfaces emit. */
    EMITTED
}
