package lightning.editor.window.property;

import java.util.Optional;
import lightning.editor.document.Change;
import lightning.editor.document.LightEdits;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.NodeEdits;
import lightning.editor.window.model.MaterialChoice;
import lightning.editor.window.model.SceneSelection;
import lightning.format.jen.NameText;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Attribute;
import lightning.scene.Keying;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.Node;
import lightning.scene.Placement;
import lightning.scene.Scene;
import lightning.scene.shot.Target;

/** One property of what is selected, in the words of the scene file. */
sealed interface PropertyOwner {
    /** As the scene file calls it. */
    String name();

    /** As people know it. */
    String title();

    /** Its value as the scene file writes it; empty where nothing is selected that has it. */
    Optional<String> text();

    /** @param value as the scene file writes it, of what the scene holds: no file is read */
    default Change set(Scene scene, String value) {
        return Change.of(() -> PropertyEdit.set(scene, target(), name(), value));
    }

    /** The value that a new one has. */
    Change reset(Scene scene);

    /** What would have its keys. */
    Target keyTarget();

    /** Whether it can have keys in the scene. */
    default boolean keyed(Scene scene) {
        return text().isPresent() && keyTarget().isIn(scene)
                && keyTarget().attribute(scene, name()).<Attribute<?, ?>>map(a -> a).filter(a -> a.kind().keying() != Keying.NONE)
                        .isPresent();
    }

    /** As an edit of a scene by text names it. */
    String target();

    /** Of the selected light. */
    record OfLight(SceneSelection selection, LightAttribute<?> attribute) implements PropertyOwner {
        @Override
        public String name() {
            return attribute.name();
        }

        @Override
        public String title() {
            return attribute.title();
        }

        @Override
        public Optional<String> text() {
            return Optional.ofNullable(selection.light()).map(light -> PropertyEdit.text(light, attribute));
        }

        @Override
        public String target() {
            return NameText.of(selection.light().name());
        }

        @Override
        public Change reset(Scene scene) {
            return LightEdits.with(scene, selection.light().name(), light -> initial(light, attribute));
        }

        @Override
        public Target keyTarget() {
            return Target.light(selection.light().name());
        }

        private static <V> Light initial(Light light, LightAttribute<V> attribute) {
            return attribute.with(light, attribute.initial());
        }
    }

    /** Of the material that is edited. */
    record OfMaterial(MaterialChoice materials, MaterialAttribute<?> attribute) implements PropertyOwner {
        @Override
        public String name() {
            return attribute.name();
        }

        @Override
        public String title() {
            return attribute.title();
        }

        @Override
        public Optional<String> text() {
            return Optional.ofNullable(materials.material()).map(material -> PropertyEdit.text(material, attribute.name()));
        }

        @Override
        public String target() {
            return PropertyEdit.target(materials.material());
        }

        @Override
        public Change reset(Scene scene) {
            return MaterialEdits.with(scene, materials.material().name(), material -> initial(material, attribute));
        }

        @Override
        public Target keyTarget() {
            return Target.CAMERA;
        }

        @Override
        public boolean keyed(Scene scene) {
            return false;
        }

        private static <V> Material initial(Material material, MaterialAttribute<V> attribute) {
            return attribute.with(material, attribute.initial());
        }
    }

    /** Of the placement of the selected shape or group. */
    record OfNode(SceneSelection selection, String name) implements PropertyOwner {
        @Override
        public String title() {
            return switch (name) {
                case "at" -> "position";
                case "rotate" -> "rotation";
                default -> name;
            };
        }

        @Override
        public Optional<String> text() {
            return selection.node().map(node -> PropertyEdit.text(node, name));
        }

        @Override
        public String target() {
            return NameText.of(selection.node().map(Node::name).orElse(""));
        }

        @Override
        public Target keyTarget() {
            return Target.node(selection.node().map(Node::name).orElse(""));
        }

        @Override
        public Change reset(Scene scene) {
            Placement still = Placement.IDENTITY;
            return NodeEdits.placement(scene, selection.node().map(Node::name).orElse(""), p -> switch (name) {
                case "at" -> new Placement(still.at(), p.rotate(), p.scale());
                case "rotate" -> new Placement(p.at(), still.rotate(), p.scale());
                default -> new Placement(p.at(), p.rotate(), still.scale());
            });
        }
    }
}
