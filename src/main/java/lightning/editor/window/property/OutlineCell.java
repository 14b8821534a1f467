package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.util.Map;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.geometry.Insets;
import javafx.scene.control.Button;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import lightning.base.text.Messages;
import lightning.document.NodeEdits;
import lightning.editor.Command;
import lightning.editor.window.command.MaterialDrop;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.node.NodeGroup;
import lightning.scene.node.SceneNode;
import lightning.scene.node.Shape;
import lightning.scene.node.Solid;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignE;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;
import org.kordamp.ikonli.materialdesign2.MaterialDesignV;

/** Cell of the shape list: icon, name, visibility, and an expander for groups. A double click renames. */
final class OutlineCell extends NamedCell<OutlineRow> {
    private static final PseudoClass DARK = PseudoClass.getPseudoClass("dark");
    private static final double INDENT = 14;
    /** Icons by solid type; others use a generic shape icon. */
    private static final Map<Class<? extends Solid>, Ikon> ICONS = Map.of(
            Solid.Sphere.class, MaterialDesignC.CIRCLE_OUTLINE,
            Solid.Cone.class, MaterialDesignC.CONE,
            Solid.Cylinder.class, MaterialDesignC.CYLINDER,
            Solid.Frustum.class, MaterialDesignC.CUP_OUTLINE,
            Solid.Plane.class, MaterialDesignS.SQUARE_OUTLINE,
            Solid.TriangleMesh.class, MaterialDesignV.VECTOR_POLYGON);

    private final SceneEditor editor;
    private final OutlinePane pane;
    private final Button foldButton = new Button();
    private final FontIcon arrow = new FontIcon();
    private final FontIcon kind = new FontIcon();
    private final ToggleButton eye = LightCell.toggle("eye");
    private final FontIcon eyeIcon = new FontIcon();
    private final HBox row = new HBox(foldButton, kind, name, eye);
    private @Nullable SceneNode shownNode;

    OutlineCell(SceneEditor editor, MaterialSelection materials, CommandRegistry commands, OutlinePane pane) {
        super(commands, Command.RENAME_SHAPE, (old, typed) -> typed.equals(old) ? Optional.empty() : pane.rename(old, typed));
        this.editor = editor;
        this.pane = pane;
        foldButton.setGraphic(arrow);
        foldButton.getStyleClass().addAll("flat", "fold");
        foldButton.setFocusTraversable(false);
        foldButton.setOnAction(_ -> pane.toggleExpanded(node().name()));
        kind.getStyleClass().add("light-type");
        eye.setGraphic(eyeIcon);
        eye.setOnAction(_ -> {
            editor.editOrReport(
                    scene -> NodeEdits.setVisible(scene, node().name(), !node().visible()));
            show();
        });
        LinkDrop.installOnShape(this, () -> shownNode == null ? null : shownNode.name(), editor);
        MaterialDrop.accept(this, (material, _) -> {
            if (shownNode != null) {
                MaterialDrop.apply(editor, materials, shownNode.name(), material);
            }
        });
        row.getStyleClass().add("light-row");
        editor.sceneProperty().subscribe(_ -> show());
        setOnMouseClicked(event -> {
            if (event.getClickCount() == 2 && shownNode != null) {
                commands.run(Command.RENAME_SHAPE);
            }
        });
    }

    @Override
    protected void updateItem(OutlineRow item, boolean empty) {
        super.updateItem(item, empty);
        show();
    }

    private void show() {
        SceneNode node = isEmpty() || getItem() == null ? null : getItem().node(editor.scene().stage());
        setGraphic(node == null ? null : row);
        if (node == null) {
            setAccessibleText(null);
        } else {
            show(node);
        }
        shownNode = node;
    }

    private void show(SceneNode node) {
        // The click has toggled the button, regardless of the edit's result.
        eye.setSelected(node.visible());
        row.setPadding(new Insets(0, 0, 0, INDENT * getItem().depth()));
        foldButton.setVisible(node instanceof NodeGroup);
        arrow.setIconCode(pane.isExpanded(node.name()) ? MaterialDesignC.CHEVRON_DOWN : MaterialDesignC.CHEVRON_RIGHT);
        if (node == shownNode) {
            return;
        }
        foldButton.setAccessibleText(Messages.tr("collapse or expand {0}", node.name()));
        kind.setIconCode(icon(node));
        name.setText(node.name());
        eyeIcon.setIconCode(node.visible() ? MaterialDesignE.EYE_OUTLINE : MaterialDesignE.EYE_OFF_OUTLINE);
        LightCell.describe(eye, Messages.tr("{0} visible", node.name()),
                node.visible() ? Messages.tr("Hide the object and its shadow") : Messages.tr("Show the object"));
        row.pseudoClassStateChanged(DARK, !node.visible());
        setAccessibleText(node.name() + ", " + noun(node) + (node.visible() ? "" : Messages.tr(", hidden")));
    }

    /** Returns the node's type as displayed. */
    static String noun(SceneNode node) {
        return switch (node) {
            case NodeGroup _ -> Messages.tr("group");
            case Shape s -> s.solid().typeName();
        };
    }

    private static Ikon icon(SceneNode node) {
        return switch (node) {
            case NodeGroup _ -> MaterialDesignF.FOLDER_OUTLINE;
            case Shape s -> ICONS.getOrDefault(s.solid().getClass(), MaterialDesignS.SHAPE_OUTLINE);
        };
    }

    @Override
    Optional<String> renameTarget() {
        return Optional.ofNullable(shownNode).map(SceneNode::name);
    }

    /** Returns the node of the cell, whose buttons are shown only with one. */
    private SceneNode node() {
        return requireNonNull(shownNode);
    }
}
