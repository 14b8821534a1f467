package lightning.scene;

/** One entry of the scene's tree: a shape, or a group that places several nodes together. */
public sealed interface Node permits Shape, Group {
    /** Unique among all shapes, groups and lights. */
    String name();

    Placement placement();

    /** Whether it is there at all; what is in a group that is not is not either. */
    boolean visible();

    Node withPlacement(Placement v);

    Node withVisible(boolean v);
}
