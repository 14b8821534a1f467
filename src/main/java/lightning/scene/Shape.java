package lightning.scene;

/**
 * A solid that is put into the scene by its placement.
 *
 * @param material the name of a material of the scene
 */
public record Shape(Solid solid, String name, String material, Placement placement) implements Node {
    public Shape {
        Limits.name(name);
    }

    public Shape withName(String v) {
        return new Shape(solid, v, material, placement);
    }

    public Shape withMaterial(String v) {
        return new Shape(solid, name, v, placement);
    }

    public Shape withPlacement(Placement v) {
        return new Shape(solid, name, material, v);
    }
}
