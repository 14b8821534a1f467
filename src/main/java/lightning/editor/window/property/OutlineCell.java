package lightning.editor.window.property;

import java.util.Map;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.geometry.Insets;
import javafx.scene.control.Button;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.NodeEdits;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Group;
import lightning.scene.Node;
import lightning.scene.Shape;
import lightning.scene.Solid;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignE;
import org.kordamp.ikonli.materialdesign2.MaterialDesignF;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;
import org.kordamp.ikonli.materialdesign2.MaterialDesignV;

/** A line of the list of shapes: kind, name, which a double click renames in place, and an eye; of a group the arrow that folds it. */
final class OutlineCell extends NamedCell<OutlineRow> {
    private static final PseudoClass DARK = PseudoClass.getPseudoClass("dark");
    private static final double INDENT = 14;
    /** What looks like the form; others look like a shape. */
    private static final Map<Class<? extends Solid>, Ikon> ICONS = Map.of(
            Solid.Sphere.class, MaterialDesignC.CIRCLE_OUTLINE,
            Solid.Cone.class, MaterialDesignC.CONE,
            Solid.Cylinder.class, MaterialDesignC.CYLINDER,
            Solid.Frustum.class, MaterialDesignC.CUP_OUTLINE,
            Solid.Plane.class, MaterialDesignS.SQUARE_OUTLINE,
            Solid.Triangles.class, MaterialDesignV.VECTOR_POLYGON);

    private final SceneEditor editor;
    private final OutlinePane pane;
    private final Button fold = new Button();
    private final FontIcon arrow = new FontIcon();
    private final FontIcon kind = new FontIcon();
    private final ToggleButton eye = LightCell.toggle("eye");
    private final FontIcon lid = new FontIcon();
    private final HBox row = new HBox(fold, kind, name, eye);
    private Node shown;

    OutlineCell(SceneEditor editor, Commands commands, OutlinePane pane) {
        super(commands, Command.RENAME_SHAPE, (old, typed) -> typed.equals(old) ? Optional.empty() : pane.rename(old, typed));
        this.editor = editor;
        this.pane = pane;
        fold.setGraphic(arrow);
        fold.getStyleClass().addAll("flat", "fold");
        fold.setFocusTraversable(false);
        fold.setOnAction(_ -> pane.fold(shown.name()));
        kind.getStyleClass().add("light-type");
        eye.setGraphic(lid);
        eye.setOnAction(_ -> {
            editor.editOrReport(scene -> NodeEdits.visible(scene, shown.name(), !shown.visible()));
            show();
        });
        LinkDrop.ofShape(this, () -> shown == null ? null : shown.name(), editor);
        row.getStyleClass().add("light-row");
        editor.sceneProperty().subscribe(_ -> show());
        setOnMouseClicked(event -> {
            if (event.getClickCount() == 2 && shown != null) {
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
        Node node = isEmpty() || getItem() == null ? null : getItem().node(editor.scene().stage());
        setGraphic(node == null ? null : row);
        if (node == null) {
            setAccessibleText(null);
        } else {
            show(node);
        }
        shown = node;
    }

    private void show(Node node) {
        // A click has switched it already, whatever came of it.
        eye.setSelected(node.visible());
        row.setPadding(new Insets(0, 0, 0, INDENT * getItem().depth()));
        fold.setVisible(node instanceof Group);
        arrow.setIconCode(pane.isUnfolded(node.name()) ? MaterialDesignC.CHEVRON_DOWN : MaterialDesignC.CHEVRON_RIGHT);
        if (node == shown) {
            return;
        }
        fold.setAccessibleText(Texts.of("fold or unfold {0}", node.name()));
        kind.setIconCode(icon(node));
        name.setText(node.name());
        lid.setIconCode(node.visible() ? MaterialDesignE.EYE_OUTLINE : MaterialDesignE.EYE_OFF_OUTLINE);
        LightCell.describe(eye, Texts.of("{0} visible", node.name()),
                node.visible() ? Texts.of("Hide it: no picture, no shadow") : Texts.of("Show it again"));
        row.pseudoClassStateChanged(DARK, !node.visible());
        setAccessibleText(node.name() + ", " + noun(node) + (node.visible() ? "" : Texts.of(", hidden")));
    }

    /** What it is, for people. */
    static String noun(Node node) {
        return switch (node) {
            case Group _ -> Texts.of("group");
            case Shape s -> s.solid().noun();
        };
    }

    private static Ikon icon(Node node) {
        return switch (node) {
            case Group _ -> MaterialDesignF.FOLDER_OUTLINE;
            case Shape s -> ICONS.getOrDefault(s.solid().getClass(), MaterialDesignS.SHAPE_OUTLINE);
        };
    }

    @Override
    Optional<String> renamed() {
        return Optional.ofNullable(shown).map(Node::name);
    }
}
