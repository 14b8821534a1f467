package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.TitledPane;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.VBox;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.document.MaterialLibrary;
import lightning.document.loop.SamplePictures;
import lightning.document.loop.SamplePictures.SamplePicture;
import lightning.editor.EditorState;
import lightning.editor.window.command.MaterialDrop;
import lightning.editor.window.model.MaterialSelection;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PixelImage;
import lightning.editor.window.widget.VisibilityListener;
import lightning.scene.Scene;
import lightning.scene.material.Material;
import lightning.scene.node.SceneNode;

/**
 * Library of materials with pictures. A click gives a material to the selected object; without one, to all objects of the material that the
 * pane shows. A drag gives it to the object where it ends.
 */
final class MaterialLibraryPane extends VBox {
    private static final double TILE = 64;

    private final SceneEditor editor;
    private final MaterialSelection materials;
    private final Executor windowExecutor;
    private final SamplePictures pictures = new SamplePictures();
    private final Map<String, ImageView> views = new LinkedHashMap<>();
    private final FlowPane tiles = new FlowPane();
    private final Label target = SectionLayout.caption("");
    private Subscription rendering = Subscription.EMPTY;
    private boolean isVisibleInWindow;
    private boolean isOpen;

    /** @param windowExecutor runs tasks in order on the window's thread */
    MaterialLibraryPane(SceneEditor editor, MaterialSelection materials, Executor windowExecutor) {
        this.editor = editor;
        this.materials = materials;
        this.windowExecutor = windowExecutor;
        setId("material-library");
        getStyleClass().add("material-library");
        target.setWrapText(true);
        tiles.getStyleClass().add("material-tiles");
        getChildren().addAll(target, tiles);
        editor.editorStateProperty().map(EditorState::selectedNode).subscribe(_ -> showTarget());
        materials.materialProperty().subscribe(_ -> showTarget());
        VisibilityListener.attach(this, () -> {
            isVisibleInWindow = true;
            update();
            return () -> {
                isVisibleInWindow = false;
                update();
            };
        });
    }

    /** Returns a section with the library, closed at first. */
    TitledPane section() {
        TitledPane section = SectionLayout.section(Messages.tr("Library"), this);
        section.setId("library-section");
        section.setExpanded(false);
        section.expandedProperty().subscribe(on -> {
            isOpen = on;
            update();
        });
        return section;
    }

    private void update() {
        rendering.unsubscribe();
        rendering = Subscription.EMPTY;
        if (isOpen && isVisibleInWindow) {
            if (views.isEmpty()) {
                MaterialLibrary.materials().forEach(m -> tiles.getChildren().add(tile(m)));
            }
            Map<String, Scene> samples = new LinkedHashMap<>();
            MaterialLibrary.materials().forEach(m -> samples.put(m.name(), MaterialLibrary.sample(m)));
            Runnable cancel = pictures.request(samples, (name, picture) -> windowExecutor.execute(() -> show(name, picture)));
            rendering = cancel::run;
        }
    }

    private void show(String name, SamplePicture picture) {
        requireNonNull(views.get(name)).setImage(PixelImage.of(picture.width(), picture.height(), picture.pixels()));
    }

    private Button tile(Material material) {
        String title = SectionLayout.title(material.name());
        var view = new ImageView();
        view.setFitWidth(TILE);
        view.setFitHeight(TILE);
        views.put(material.name(), view);
        var frame = new VBox(view);
        frame.setMinSize(TILE, TILE);
        frame.getStyleClass().add("material-picture");
        var tile = new Button(title, frame);
        tile.setId("library-" + material.name().replace(' ', '-'));
        tile.setContentDisplay(ContentDisplay.TOP);
        tile.setWrapText(true);
        tile.getStyleClass().addAll("flat", "material-tile");
        tile.setTooltip(new Tooltip(Messages.tr("{0}. Click applies it; drag it onto an object in a picture or in the list", title)));
        tile.setOnAction(_ -> apply(material));
        MaterialDrop.makeDraggable(tile, material, view::getImage);
        return tile;
    }

    private Optional<SceneNode> node() {
        return editor.selection().node();
    }

    private void showTarget() {
        Material shown = materials.material();
        target.setText(node().map(n -> Messages.tr("A click applies it to {0}", n.name()))
                .orElseGet(() -> shown == null ? "" : Messages.tr("A click applies it to all objects of {0}", shown.name())));
    }

    private void apply(Material material) {
        Material shown = materials.material();
        if (node().isPresent()) {
            MaterialDrop.apply(editor, materials, node().get().name(), material);
        } else if (shown != null && editor.editOrReport(scene -> MaterialLibrary.replace(scene, shown.name(), material)).isEmpty()) {
            materials.choose(nameOf(material));
        }
    }

    /** Returns the name of a material in the scene. */
    private String nameOf(Material material) {
        return editor.scene().materials().reversed().stream().filter(m -> m.withName(material.name()).equals(material)).map(Material::name)
                .findFirst().orElse(material.name());
    }
}
