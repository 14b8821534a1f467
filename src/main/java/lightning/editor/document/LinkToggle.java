package lightning.editor.document;

import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Scene;
import lightning.scene.ShapeLinks;

/** Edits of light linking for one shape: whether a light illuminates it, or casts its shadow. */
public final class LinkToggle {
    private LinkToggle() {}

    /** Returns true if the links of an attribute contain a shape, by its own name or that of a group around it. */
    public static boolean isLinked(Scene scene, Light light, LightAttribute<ShapeLinks> attribute, String shape) {
        ShapeLinks links = attribute.get(light);
        return links.exclusive() == links.names().contains(decidingNode(scene, links, shape));
    }

    /**
     * Returns the node whose name decides if a shape is linked: the outermost listed group around it, or the shape itself.
     *
     * @param shape name of the shape
     */
    public static String decidingNode(Scene scene, ShapeLinks links, String shape) {
        return scene.stage().enclosingGroups(shape).stream().map(group -> group.name()).filter(links.names()::contains).findFirst()
                .orElse(shape);
    }

    /** Links the deciding node of a shape, or unlinks it. */
    public static EditOutcome toggle(Scene scene, String light, LightAttribute<ShapeLinks> attribute, String shape) {
        return LightEdits.edit(scene, light, l -> {
            ShapeLinks links = attribute.get(l);
            String node = decidingNode(scene, links, shape);
            return attribute.with(l, links.with(node, !links.names().contains(node)));
        });
    }
}
