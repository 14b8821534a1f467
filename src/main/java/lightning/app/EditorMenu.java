package lightning.app;

import java.util.List;
import java.util.Optional;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleGroup;
import javafx.scene.input.KeyCombination;
import lightning.app.command.CommandButton;
import lightning.app.command.CommandFace;
import lightning.app.command.FileActions;
import lightning.app.command.Notices;
import lightning.app.command.SizeMenu;
import lightning.app.model.EditorModel;
import lightning.app.model.Precision;
import lightning.app.preview.PreviewItems;
import lightning.app.preview.PreviewPane;
import lightning.app.traced.LightPlacer;
import lightning.app.traced.SamplingMenu;
import lightning.app.traced.TracedPane;
import lightning.app.traced.ViewItems;
import lightning.app.widget.Looks;
import lightning.app.widget.PictureView;
import lightning.edit.Command;
import lightning.edit.PreviewCamera;
import org.kordamp.ikonli.javafx.FontIcon;

/** Every command in a menu, with its shortcut. */
final class EditorMenu extends MenuBar {
    private static final double ZOOM = 1.5;

    private final EditorModel model;

    EditorMenu(EditorModel model, FileActions files, TracedPane traced, PreviewPane preview, Notices notices, Panels windows) {
        this.model = model;
        var recent = new Menu("Load Recent");
        recent.setId("recent");
        recent.setOnShowing(_ -> recent.getItems().setAll(files.recentItems()));
        recent.getItems().setAll(files.recentItems());
        var file = menu("File", item(Command.LOAD_FILE), recent, item(Command.RELOAD), new SeparatorMenuItem(),
                item(Command.SAVE_SCENE), item(Command.SAVE_SCENE_AS), item(Command.SAVE_IMAGE), new SeparatorMenuItem(),
                item("Quit", "Shortcut+Q", files::quit));
        var edit = menu("Edit", item(Command.UNDO), item(Command.REDO), new SeparatorMenuItem(), item(Command.UNDO_LIGHT),
                item(Command.REDO_LIGHT), new SeparatorMenuItem(), item(Command.COPY_SETTINGS), item(Command.PASTE_SETTINGS),
                new SeparatorMenuItem(), item(Command.PICK_MATERIAL));
        var light = menu("Light", item(Command.ADD_LIGHT), item(Command.DUPLICATE_LIGHT), item(Command.DELETE_LIGHT),
                new SeparatorMenuItem(), item(Command.RENAME_LIGHT), item(Command.SWITCH_ON), item(Command.SOLO),
                lookThrough(), new SeparatorMenuItem(), item(Command.AIM),
                placing("Place Highlight…", "Shortcut+Shift+G", traced.placer(), traced.placer()::highlight),
                placing("Place Shadow…", "Shortcut+Shift+D", traced.placer(), traced.placer()::shadow), new SeparatorMenuItem(),
                item(Command.MAKE_ANIMATION));
        var live = new CheckMenuItem("Live");
        live.setAccelerator(KeyCombination.valueOf("F8"));
        live.selectedProperty().bindBidirectional(model.liveProperty());
        var render = menu("Render", item(Command.GO), live, item(Command.UPDATE_REFLECTIONS), item(Command.VERIFY),
                item(Command.CANCEL), new SeparatorMenuItem(), item("What Accuracy Costs…", "F9", windows::accuracy),
                item("Effects…", "Shift+F9", windows::effects),
                new SeparatorMenuItem(), precision(), sizes(), SamplingMenu.of(model, "menu-antialias"));
        var help = menu("Help", item("Mouse and Keyboard", "F1", windows::keys),
                item("About Lightning", "", () -> About.show(notices)));
        getMenus().setAll(file, edit, light, render, view(traced, preview), help);
    }

    private Menu view(TracedPane traced, PreviewPane preview) {
        PictureView picture = traced.picture();
        var only = new CheckMenuItem("Only the Selected Light");
        only.setId("menu-only-selected");
        only.setAccelerator(KeyCombination.valueOf("Shortcut+I"));
        only.selectedProperty().bindBidirectional(model.look().onlySelectedProperty());
        var shown = new Menu("Show the Picture");
        shown.getItems().setAll(ViewItems.of(model, "menu-view"));
        Menu view = menu("View", only, shown, new SeparatorMenuItem(), item("Fit Picture", "Shortcut+0", picture::fit),
                item("Actual Pixels", "Shortcut+1", picture::oneToOne),
                item("Zoom In", "Shortcut+EQUALS", () -> picture.zoomBy(ZOOM)),
                item("Zoom Out", "Shortcut+MINUS", () -> picture.zoomBy(1 / ZOOM)),
                item("Trace a Region", "Shortcut+B", traced::frameRegion), new SeparatorMenuItem(),
                item("Preview Along X", "Shortcut+F2", () -> look(PreviewCamera.alongX(model.scene()))),
                item("Preview from Above", "Shortcut+F3", () -> look(PreviewCamera.alongMinusY(model.scene()))),
                item("Reset the Preview", "Shortcut+F4", () -> look(PreviewCamera.of(model.scene()))),
                item("Show All Lights", "Shortcut+F5", preview.canvas()::frameLights), new SeparatorMenuItem());
        view.getItems().addAll(PreviewItems.of(model.previewLook()));
        view.getItems().addAll(new SeparatorMenuItem(), light());
        return view;
    }

    private static MenuItem light() {
        var light = new CheckMenuItem("Light Theme");
        light.setId("light-theme");
        light.setSelected(Looks.worn() == Looks.LIGHT);
        light.setOnAction(_ -> (light.isSelected() ? Looks.LIGHT : Looks.DARK).wear());
        return light;
    }

    private void look(PreviewCamera camera) {
        model.previewCameraProperty().set(camera);
    }

    private static Menu menu(String title, MenuItem... items) {
        return new Menu(title, null, items);
    }

    private static MenuItem item(String title, String keys, Runnable action) {
        var item = new MenuItem(title);
        if (!keys.isEmpty()) {
            item.setAccelerator(KeyCombination.valueOf(keys));
        }
        item.setOnAction(_ -> action.run());
        return item;
    }

    private MenuItem placing(String title, String keys, LightPlacer placer, Runnable action) {
        MenuItem item = item(title, keys, action);
        model.situationProperty().subscribe(_ -> item.setDisable(!placer.isEnabled()));
        return item;
    }

    private MenuItem lookThrough() {
        var item = new CheckMenuItem();
        var on = model.lookThrough().onProperty();
        on.subscribe(item::setSelected);
        command(item, Command.LOOK_THROUGH_LIGHT);
        item.setOnAction(_ -> {
            model.run(Command.LOOK_THROUGH_LIGHT);
            item.setSelected(on.get());
        });
        return item;
    }

    private MenuItem item(Command command) {
        var item = new MenuItem();
        command(item, command);
        item.setOnAction(_ -> model.run(command));
        return item;
    }

    private void command(MenuItem item, Command command) {
        CommandFace face = CommandFace.of(command);
        item.setGraphic(new FontIcon(face.icon()));
        item.setId("menu-" + CommandButton.id(command));
        item.setAccelerator(face.keys());
        model.situationProperty().subscribe(now -> {
            item.setDisable(!model.enabled(command));
            item.setText(title(command, face));
        });
    }

    /** Undo and redo say what of. */
    private String title(Command command, CommandFace face) {
        var now = model.situationProperty().get();
        var label = switch (command) {
            case UNDO -> now.undo();
            case REDO -> now.redo();
            case UNDO_LIGHT -> now.undoLight();
            case REDO_LIGHT -> now.redoLight();
            default -> Optional.<String>empty();
        };
        return face.title() + label.map(l -> " (" + l + ")").orElse("");
    }

    private Menu precision() {
        var menu = new Menu("Accuracy");
        var group = new ToggleGroup();
        for (Precision precision : Precision.values()) {
            var item = new RadioMenuItem(precision.toString());
            item.setToggleGroup(group);
            item.setOnAction(_ -> model.precisionProperty().set(precision));
            model.precisionProperty().subscribe(p -> item.setSelected(p == precision));
            menu.getItems().add(item);
        }
        return menu;
    }

    private Menu sizes() {
        var menu = new Menu("Size of the Picture");
        menu.getItems().setAll(List.copyOf(SizeMenu.ofPicture(model)));
        return menu;
    }
}
