package lightning.editor.window;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.Parent;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.skin.ContextMenuSkin;
import lightning.base.text.Messages;
import lightning.document.CameraEdits;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.command.FileActions;
import lightning.editor.window.command.SizeMenu;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.UiLanguage;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.preview.PreviewMenuItems;
import lightning.editor.window.traced.IndirectMenu;
import lightning.editor.window.traced.ReflectionMenu;
import lightning.editor.window.traced.SamplingMenu;
import lightning.editor.window.traced.ViewMenuItems;
import lightning.editor.window.widget.ColorTheme;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;

/** Menu bar with all commands and their shortcuts. */
final class EditorMenu extends MenuBar {
    /** Marks a separator line between items. */
    private static final @Nullable Command SEPARATOR = null;

    private final EditorModel model;
    private final CommandMenuItems items;

    /** Creates the menus. All commands that do not open a submenu must already be registered. */
    EditorMenu(EditorModel model, FileActions files) {
        this.model = model;
        items = CommandMenuItems.forMenuBar(model.commands());
        Menu file =
                menu(Messages.tr("File"), Command.NEW_SCENE, Command.LOAD_FILE, Command.WELCOME, Command.RELOAD, Command.RECOVER, SEPARATOR,
                        Command.SAVE_SCENE,
                        Command.SAVE_SCENE_AS,
                        Command.SAVE_IMAGE, Command.OPEN_REVIEW, Command.LIVE_REVIEW,
                        SEPARATOR, Command.QUIT);
        file.getItems().add(2, recent(files));
        file.getItems().add(file.getItems().size() - 4, export(files));
        Menu edit = menu(Messages.tr("Edit"), Command.UNDO, Command.REDO, SEPARATOR, Command.UNDO_LIGHT, Command.REDO_LIGHT,
                Command.HISTORY_PANEL,
                SEPARATOR,
                Command.COPY_SETTINGS,
                Command.PASTE_SETTINGS, SEPARATOR, Command.PICK_MATERIAL, Command.EDIT_WORLD);
        Menu place = submenu(Messages.tr("Place Light"), "mdi2t-target", Command.AIM, Command.PLACE_HIGHLIGHT, Command.PLACE_DIFFUSE,
                Command.PLACE_RIM,
                Command.PLACE_SHADOW, Command.PLACE_FLAG);
        Menu group =
                submenu(Messages.tr("Light Group"), "mdi2l-lightbulb-group-outline", Command.NEW_LIGHT_GROUP, Command.DELETE_LIGHT_GROUP);
        Menu rig = submenu(Messages.tr("Light Rig"), "mdi2f-file-outline", Command.LOAD_RIG, Command.ADD_RIG, Command.SAVE_RIG);
        Menu light = menu(Messages.tr("Light"), Command.ADD_LIGHT, Command.DUPLICATE_LIGHT, Command.DELETE_LIGHT, Command.RENAME_LIGHT,
                SEPARATOR,
                Command.SWITCH_ON, Command.SOLO, Command.LOOK_THROUGH_LIGHT);
        light.getItems().addAll(place, group, rig);
        add(light, SEPARATOR, Command.MIXER, Command.LIGHT_LINKS, Command.CONTRIBUTIONS, Command.MATCH_REFERENCE, Command.LOOKS,
                Command.MAKE_ANIMATION);
        Menu shape = menu(Messages.tr("Object"), Command.DUPLICATE_SHAPE, Command.DELETE_SHAPE, Command.RENAME_SHAPE, SEPARATOR,
                Command.SHOW_SHAPE, Command.ADD_BLOCKER, Command.MAKE_LIGHT, Command.LIGHTS_OF_GLOW);
        Menu shot = menu(Messages.tr("Shot"), Command.TIMELINE, Command.FILM_STRIP, Command.SEQUENCE, SEPARATOR, Command.NEW_SHOT,
                Command.DELETE_SHOT, Command.EXPORT_SHOT, SEPARATOR, Command.PLAY_SHOT);
        shot.getItems()
                .add(submenu(Messages.tr("Go to Frame"), "mdi2s-skip-next-outline", Command.FIRST_FRAME, Command.PREVIOUS_FRAME,
                        Command.NEXT_FRAME,
                        Command.LAST_FRAME, SEPARATOR, Command.PREVIOUS_KEY, Command.NEXT_KEY));
        add(shot, SEPARATOR, Command.SET_KEY, Command.DELETE_KEYS);
        shot.getItems()
                .addAll(submenu(Messages.tr("Interpolation"), "mdi2c-chart-bell-curve-cumulative", Command.LINEAR_KEYS, Command.SMOOTH_KEYS,
                        Command.STEPPED_KEYS),
                        submenu(Messages.tr("Motion Path"), "mdi2v-vector-polyline", Command.WAY_TO_KEYS, Command.KEYS_TO_WAY));
        Menu render =
                menu(Messages.tr("Render"), Command.GO, Command.LIVE, Command.UPDATE_REFLECTIONS, Command.VERIFY, Command.CANCEL, SEPARATOR,
                        Command.UPDATES_PANEL, Command.ACCURACY_PANEL, Command.COMPARE_SETTINGS, Command.EFFECTS_PANEL,
                        Command.KEEP_PICTURES,
                        SEPARATOR);
        render.getItems().addAll(accuracy(), sizes(), SamplingMenu.of(model.editor(), items), IndirectMenu.of(model.editor(), items),
                ReflectionMenu.of(model.editor(), items));
        getMenus().setAll(file, edit, light, shape, shot, render, view(),
                menu(Messages.tr("Help"), Command.PALETTE, Command.KEYS, Command.ABOUT));
    }

    /**
     * Returns steps that build and style each menu before it is opened. This halves the time of the first opening, although the toolkit
     * applies the styles again.
     */
    Stream<Runnable> preloadSteps() {
        return getMenus().stream().flatMap(menu -> Stream.of(() -> popup(menu).ifPresent(EditorMenu::createSkin),
                () -> popup(menu).ifPresent(EditorMenu::layOut)));
    }

    /** Returns the menu's popup window, which exists once the menu bar is styled. */
    private static Optional<ContextMenu> popup(Menu menu) {
        return Optional.ofNullable(menu.getItems().getFirst().getParentPopup());
    }

    private static void layOut(ContextMenu menu) {
        Parent lines = menu.getScene().getRoot();
        lines.applyCss();
        lines.layout();
    }

    private static void createSkin(ContextMenu menu) {
        ColorTheme.style(menu.getScene());
        if (menu.getSkin() == null) {
            menu.setSkin(new ContextMenuSkin(menu));
        }
    }

    private Menu menu(String title, @Nullable Command... commands) {
        var menu = new Menu(title);
        add(menu, commands);
        return menu;
    }

    private Menu submenu(String title, String icon, @Nullable Command... commands) {
        Menu menu = menu(title, commands);
        menu.setGraphic(new FontIcon(icon));
        return menu;
    }

    private void add(Menu menu, @Nullable Command... commands) {
        for (Command command : commands) {
            menu.getItems().add(command == SEPARATOR ? new SeparatorMenuItem() : items.item(command));
        }
    }

    private Menu recent(FileActions files) {
        Menu recent = items.menu(Command.LOAD_RECENT);
        recent.setOnShowing(_ -> recent.getItems().setAll(files.recentItems()));
        recent.getItems().setAll(files.recentItems());
        return recent;
    }

    private Menu export(FileActions files) {
        Menu export = items.menu(Command.EXPORT);
        export.getItems().setAll(files.exportItems());
        return export;
    }

    private Menu view() {
        var light = new SimpleBooleanProperty(ColorTheme.current() == ColorTheme.LIGHT);
        light.addListener((_, _, on) -> (on ? ColorTheme.LIGHT : ColorTheme.DARK).apply());
        model.commands().setToggle(Command.LIGHT_THEME, light);
        Menu view = menu(Messages.tr("View"), Command.ONLY_SELECTED, Command.SCOPES);
        view.getItems().add(
                new Menu(Messages.tr("View Options"), new FontIcon("mdi2e-eye-settings-outline"),
                        ViewMenuItems.of(model.viewActions(), items).toArray(MenuItem[]::new)));
        Menu preview = submenu(Messages.tr("Preview"), "mdi2e-eye-outline", Command.VIEW_X, Command.VIEW_Y, Command.VIEW_Z,
                Command.VIEW_ALL, SEPARATOR);
        preview.getItems().addAll(PreviewMenuItems.of(model.previewSettings(), items));
        Menu camera = submenu(Messages.tr("Camera"), "mdi2c-camera-outline", Command.MOVE_CAMERA, Command.USE_VIEW);
        camera.getItems().add(cameras());
        add(view, SEPARATOR, Command.REGION);
        view.getItems()
                .addAll(submenu(Messages.tr("Zoom"), "mdi2m-magnify", Command.TRACED_FIT, Command.TRACED_ONE_TO_ONE, Command.TRACED_ZOOM_IN,
                        Command.TRACED_ZOOM_OUT), camera, preview, new SeparatorMenuItem(), canvases(), arrangement());
        add(view, Command.PREVIEW_INSET, Command.HIDE_PANELS, Command.FULL_SCREEN, SEPARATOR, Command.LIGHT_THEME);
        view.getItems().add(languages());
        return view;
    }

    /** Returns a menu with the scene's named cameras. */
    private Menu cameras() {
        Menu menu = items.menu(Command.CHOOSE_CAMERA);
        Runnable fill = () -> {
            List<MenuItem> named = model.editor().scene().cameraNames().stream().map(name -> items.value(Command.CHOOSE_CAMERA, name,
                    () -> model.editor().editAndRenderOrReport(scene -> CameraEdits.choose(scene, name), null))).toList();
            menu.getItems().setAll(named.isEmpty()
                    ? List.of(
                            CommandMenuItems.placeholder(Command.CHOOSE_CAMERA, Messages.tr("No Named Cameras: World > Camera saves them")))
                    : named);
        };
        menu.setOnShowing(_ -> fill.run());
        fill.run();
        return menu;
    }

    private Menu arrangement() {
        return submenu(Messages.tr("Arrangement"), "mdi2v-view-dashboard-outline", Command.ARRANGE_LIGHT, Command.ARRANGE_COMPARE,
                Command.ARRANGE_SHOT, SEPARATOR,
                Command.NEXT_PANEL, Command.PREVIOUS_PANEL, SEPARATOR, Command.FLOAT_PANEL, Command.MOVE_PANEL, Command.CLOSE_PANEL);
    }

    private Menu canvases() {
        Menu menu = items.menu(Command.ARRANGEMENT);
        var chosen = model.layout().canvasLayoutProperty();
        for (CanvasLayout value : CanvasLayout.values()) {
            menu.getItems().add(items.choice(Command.ARRANGEMENT, "canvases-" + value.name(), value.toString(), chosen.map(c -> c == value),
                    () -> chosen.set(value)));
        }
        return menu;
    }

    private Menu languages() {
        Menu menu = items.menu(Command.LANGUAGE);
        var chosen = model.languageProperty();
        for (UiLanguage value : UiLanguage.values()) {
            menu.getItems()
                    .add(items.choice(Command.LANGUAGE, "language-" + value.name(), value.toString(), chosen.map(c -> c == value), () -> {
                        chosen.set(value);
                        model.editor().message().show(Messages.tr("The interface language changes after a restart"));
                    }));
        }
        return menu;
    }

    private Menu accuracy() {
        Menu menu = items.menu(Command.ACCURACY);
        var chosen = model.accuracyModeProperty();
        for (AccuracyMode precision : AccuracyMode.values()) {
            menu.getItems().add(items.choice(Command.ACCURACY, "accuracy-" + precision.name(), precision.toString(),
                    chosen.map(p -> p == precision), () -> chosen.set(precision)));
        }
        return menu;
    }

    private Menu sizes() {
        Menu menu = items.menu(Command.PICTURE_SIZE);
        menu.getItems().setAll(List.copyOf(SizeMenu.pictureSizeItems(model.editor(), items, model.layout())));
        return menu;
    }
}
