package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.LightEdits;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.NodeEdits;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneSelection;
import lightning.format.jen.NameSyntax;
import lightning.format.jen.PropertyEdit;
import lightning.scene.Scene;
import lightning.scene.attribute.KeyframeSupport;
import lightning.scene.attribute.SceneAttribute;
import lightning.scene.light.LightAttribute;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.node.SceneNode;
import lightning.scene.shot.TrackTarget;
import lightning.scene.value.Placement;

/** Property of the selected item, in scene-file syntax. */
sealed interface SelectedProperty {
    /** Returns the name in the scene file. */
    String name();

    /** Returns the display title. */
    String title();

    /** Returns the value in scene-file syntax, or empty if no item with the property is selected. */
    Optional<String> text();

    /** @param value  value in scene-file syntax; may refer only to loaded assets, since no file is read */
    default EditOutcome set(Scene scene, String value) {
        return EditOutcome.of(() -> PropertyEdit.set(scene, target(), name(), value));
    }

    /** Resets the property to its initial value. */
    EditOutcome reset(Scene scene);

    /** Returns the target of the property's keyframes. */
    TrackTarget keyTarget();

    /** Returns whether the property can be animated in the scene. */
    default boolean canHaveKeys(Scene scene) {
        return text().isPresent() && keyTarget().existsIn(scene)
                && keyTarget().attribute(scene, name()).<SceneAttribute<?, ?>>map(a -> a)
                        .filter(a -> a.kind().keyframeSupport() != KeyframeSupport.NONE)
                        .isPresent();
    }

    /** Returns the item's name in text edits of a scene. */
    String target();

    /** Property that is an attribute of the item. */
    sealed interface OfAttribute extends SelectedProperty {
        SceneAttribute<?, ?> attribute();

        @Override
        default String name() {
            return attribute().name();
        }

        @Override
        default String title() {
            return attribute().title();
        }
    }

    /** Property of the selected light. */
    record LightProperty(SceneSelection selection, LightAttribute<?> attribute) implements OfAttribute {
        @Override
        public Optional<String> text() {
            return Optional.ofNullable(selection.light()).map(light -> PropertyEdit.text(light, attribute));
        }

        @Override
        public String target() {
            return NameSyntax.format(requireNonNull(selection.light()).name());
        }

        @Override
        public EditOutcome reset(Scene scene) {
            return LightEdits.edit(scene, requireNonNull(selection.light()).name(), attribute::reset);
        }

        @Override
        public TrackTarget keyTarget() {
            return TrackTarget.light(requireNonNull(selection.light()).name());
        }
    }

    /** Property of the material being edited. */
    record MaterialProperty(MaterialSelection materials, MaterialAttribute<?> attribute) implements OfAttribute {
        @Override
        public Optional<String> text() {
            return Optional.ofNullable(materials.material()).map(material -> PropertyEdit.text(material, attribute.name()));
        }

        @Override
        public String target() {
            return PropertyEdit.target(requireNonNull(materials.material()));
        }

        @Override
        public EditOutcome reset(Scene scene) {
            return MaterialEdits.edit(scene, requireNonNull(materials.material()).name(), attribute::reset);
        }

        @Override
        public TrackTarget keyTarget() {
            return TrackTarget.CAMERA;
        }

        @Override
        public boolean canHaveKeys(Scene scene) {
            return false;
        }
    }

    /** Property of the selected shape's or group's placement. */
    record NodeProperty(SceneSelection selection, String name) implements SelectedProperty {
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
            return NameSyntax.format(selection.node().map(SceneNode::name).orElse(""));
        }

        @Override
        public TrackTarget keyTarget() {
            return TrackTarget.node(selection.node().map(SceneNode::name).orElse(""));
        }

        @Override
        public EditOutcome reset(Scene scene) {
            Placement identity = Placement.IDENTITY;
            return NodeEdits.setPlacement(scene, selection.node().map(SceneNode::name).orElse(""), p -> switch (name) {
                case "at" -> new Placement(identity.position(), p.rotation(), p.scale());
                case "rotate" -> new Placement(p.position(), identity.rotation(), p.scale());
                default -> new Placement(p.position(), p.rotation(), identity.scale());
            });
        }
    }
}
