package lightning.format.matte;

import java.util.ArrayList;
import java.util.List;
import lightning.scene.Stage;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;

/** Property by which mattes separate surfaces. */
public enum MatteKind {
    /** Shape. */
    OBJECT("CryptoObject"),
    /** Material. */
    MATERIAL("CryptoMaterial"),
    /** Outermost group, or the shape if it is in no group: an imported object with all its parts. */
    ASSET("CryptoAsset");

    private final String layer;

    MatteKind(String layer) {
        this.layer = layer;
    }

    /** Returns the layer's name in a file, without a number. */
    public String layer() {
        return layer;
    }

    /** Returns the name of each visible shape's matte, in the order of {@link Stage#shapes}. */
    public List<String> names(Stage stage) {
        return switch (this) {
            case OBJECT -> stage.shapes().stream().map(Shape::name).toList();
            case MATERIAL -> stage.shapes().stream().map(Shape::material).toList();
            case ASSET -> {
                List<String> names = new ArrayList<>();
                for (SceneNode node : stage.nodes()) {
                    addAsset(node, node.name(), names);
                }
                yield names;
            }
        };
    }

    private static void addAsset(SceneNode node, String asset, List<String> names) {
        switch (node) {
            case SceneNode n when !n.visible() -> {}
            case NodeGroup group -> group.children().forEach(child -> addAsset(child, asset, names));
            case Shape _ -> names.add(asset);
        }
    }
}
