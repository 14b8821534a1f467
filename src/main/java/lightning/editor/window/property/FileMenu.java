package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import lightning.base.file.ShippedFile;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.FileImporter;
import lightning.format.jen.asset.FileKind;

/**
 * Menu of the files of a kind next to the scene, with thumbnails, None and Browse. Shows gobos before other textures. Scans the folder in
 * the background each time it opens.
 */
final class FileMenu extends MenuButton {
    /** Maximum number of files with a thumbnail. */
    private static final int MAX_THUMBNAILS = 60;

    private final CommandRegistry commands;
    private final FileImporter importer;
    private final Command command;
    private final FileKind kind;
    private final Supplier<Consumer<String>> setter;
    private final Consumer<String> onRefused;

    /**
     * @param command  command of choosing a file
     * @param setter  returns what receives the file name, empty for none; called when the user begins to choose
     * @param onRefused  receives why a file elsewhere cannot be used
     */
    FileMenu(EditorModel model, String text, Command command, FileKind kind, Supplier<Consumer<String>> setter,
            Consumer<String> onRefused) {
        super(text);
        // File names may contain underscores.
        setMnemonicParsing(false);
        commands = model.commands();
        importer = model.fileImporter();
        this.command = command;
        this.kind = kind;
        this.setter = setter;
        this.onRefused = onRefused;
        setOnShowing(_ -> loadFiles());
        showFiles(List.of());
    }

    private void loadFiles() {
        Path folder = importer.folder();
        importer.files().runConcurrently(() -> findFiles(folder), this::showFiles, _ -> showFiles(List.of()));
    }

    /**
     * Menu entry of a file.
     *
     * @param shipped file of the program that the scene does not have yet; empty for a file next to the scene
     */
    private record FileItem(String name, Optional<Path> shipped, Optional<FileThumbnail> thumbnail) {}

    /** Returns the files next to the scene, then the program's environments that are not among them. */
    private List<FileItem> findFiles(Path folder) {
        List<String> names = kind.fileNames(folder);
        List<FileItem> items = new ArrayList<>();
        for (String name : names) {
            items.add(new FileItem(name, Optional.empty(),
                    items.size() < MAX_THUMBNAILS ? FileThumbnail.of(kind, folder, name) : Optional.empty()));
        }
        ShippedFile.textures().filter(_ -> kind == FileKind.ENVIRONMENT).ifPresent(textures -> kind.fileNames(textures).stream()
                .filter(name -> !names.contains(name)).forEach(name -> items
                        .add(new FileItem(name, Optional.of(textures.resolve(name)), FileThumbnail.of(kind, textures, name)))));
        return items;
    }

    private void showFiles(List<FileItem> fileItems) {
        List<MenuItem> items = new ArrayList<>();
        items.add(item(Messages.tr("None"), ""));
        items.add(CommandMenuItems.forMenu(commands).value(command, Messages.tr("Browse…"),
                () -> importer.promptAndImport(command.plainTitle(), kind, setter.get(), onRefused)));
        items.add(new SeparatorMenuItem());
        Map<Boolean, List<MenuItem>> files = fileItems.stream().collect(Collectors.partitioningBy(found -> isSuggested(found.name()),
                Collectors.mapping(this::item, Collectors.toList())));
        List<MenuItem> suggested = requireNonNull(files.get(true));
        List<MenuItem> others = requireNonNull(files.get(false));
        items.addAll(suggested);
        if (suggested.isEmpty()) {
            items.addAll(others);
        } else if (!others.isEmpty()) {
            items.add(new Menu(Messages.tr("Other Textures"), null, others.toArray(MenuItem[]::new)));
        }
        getItems().setAll(items);
    }

    /** Returns true unless a file is probably for another purpose: images whose names do not say that they are gobos. */
    private boolean isSuggested(String name) {
        return command != Command.CHOOSE_GOBO || name.toLowerCase(Locale.ROOT).contains("gobo");
    }

    private MenuItem item(FileItem found) {
        MenuItem item = found.shipped().isEmpty() ? item(found.name(), found.name())
                : CommandMenuItems.forMenu(commands).value(command, found.name(),
                        () -> importer.importFile(kind, found.shipped().get(), setter.get(), onRefused));
        found.thumbnail().ifPresent(p -> item.setGraphic(p.view()));
        return item;
    }

    private MenuItem item(String title, String name) {
        return CommandMenuItems.forMenu(commands).value(command, title, () -> setter.get().accept(name));
    }
}
