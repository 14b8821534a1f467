package lightning.render.shading;

/** Which of the lights' contributions are composed. */
public enum LightComponent {
    ALL,
    /** What is scattered, kd·Σ Idiff. */
    DIFFUSE,
    /** What is mirrored, ks·Σ Ispec + Σ Igraz. */
    SPECULAR
}
