package lightning.render.shading.composition;

/** Component of the lights' contributions that is composed. */
public enum LightComponent {
    ALL,
    /** Diffuse component, kd·Σ Idiff. */
    DIFFUSE,
    /** Specular component, ks·Σ Ispec + Σ Igraz. */
    SPECULAR
}
