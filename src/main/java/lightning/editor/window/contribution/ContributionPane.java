package lightning.editor.window.contribution;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import javafx.animation.PauseTransition;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.scene.control.Button;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TableCell;
import javafx.scene.control.TableColumn;
import javafx.scene.control.TableRow;
import javafx.scene.control.TableView;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import javafx.util.Duration;
import javafx.util.Subscription;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.loop.Frame;
import lightning.editor.Command;
import lightning.editor.window.command.CommandMenuItems;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.PicturePointer;
import lightning.editor.window.model.PictureQuery;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.TracedPicture;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.PercentText;
import lightning.editor.window.widget.VisibilityListener;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.FilmChange;
import lightning.render.relight.LightContribution;
import lightning.render.relight.LightContributions;
import lightning.render.relight.LightThumbnails;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/**
 * Contribution of each light to the picture, to a region and to the pixel under the mouse, and the impact of removing it. One click
 * switches off all lights that change no displayed pixel, then compares the new picture with the old one.
 */
public final class ContributionPane extends VBox {
    /** Delay after an edit before the contributions are computed; a faster edit restarts it. */
    private static final Duration SETTLE_DELAY = Duration.millis(300);

    private final EditorModel model;
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final PictureQuery lightQuery;
    private final PictureQuery pixelQuery;
    private final TableView<LightContribution> table = new TableView<>();
    private final Label summary = new Label("…");
    private final Label comparisonLabel = new Label();
    /** Placeholder of the table; empty until the first result. */
    private final Label placeholder = new Label();
    private final Label regionText = new Label(Messages.tr("Region: whole frame"));
    private final DisabledReason switchOffReason;
    private final PauseTransition settleTimer = new PauseTransition(SETTLE_DELAY);
    private Map<Contribution, Double> sharesAtPointer = Map.of();
    private Map<String, Long> shadowRays = Map.of();
    private Optional<LightContributions.Region> region = Optional.empty();
    private @Nullable LightContributions shown;
    private @Nullable Scene shownScene;
    private @Nullable Frame lastFrame;
    /** Pending comparison after lights were switched off; null if there is none. */
    private @Nullable Comparison pendingComparison;

    private record Comparison(Scene scene, Film oldFilm, int lightCount) {}

    public ContributionPane(EditorModel model) {
        this.model = model;
        editor = model.editor();
        picture = model.picture();
        lightQuery = new PictureQuery(model.files().windowExecutor(), "lightning-contributions");
        pixelQuery = new PictureQuery(model.files().windowExecutor(), "lightning-pixel-share");
        setId("contributions");
        getStyleClass().add("contributions");
        summary.setId("contribution-summary");
        summary.setMaxWidth(Double.MAX_VALUE);
        HBox.setHgrow(summary, Priority.ALWAYS);
        var offButton = new Button(Messages.tr("Switch Off"));
        offButton.setId("switch-off-idle");
        offButton.getStyleClass().add("accent");
        offButton.setMinWidth(Region.USE_PREF_SIZE);
        offButton.setOnAction(_ -> switchOff());
        var offBox = new StackPane(offButton);
        switchOffReason = new DisabledReason(offBox, offButton,
                Messages.tr("Switch off all lights that change no displayed pixel"));
        switchOffReason.set(Optional.of(Messages.tr("no results yet")));
        var head = new HBox(summary, offBox);
        head.getStyleClass().add("mixer-tools");
        var regionButton = new Button(Messages.tr("Select Region…"));
        regionButton.setId("contribution-region");
        regionButton.setTooltip(new Tooltip(Messages.tr("Drag a rectangle in the rendered image")));
        regionButton.setMinWidth(Region.USE_PREF_SIZE);
        regionButton.setOnAction(_ -> pickRegion());
        var wholeButton = new Button(Messages.tr("Whole Frame"));
        wholeButton.setId("contribution-whole");
        wholeButton.setMinWidth(Region.USE_PREF_SIZE);
        wholeButton.setOnAction(_ -> setRegion(Optional.empty()));
        regionText.setId("contribution-region-text");
        regionText.getStyleClass().add("pane-note");
        var regionTools = new HBox(regionButton, wholeButton, regionText);
        regionTools.getStyleClass().add("mixer-tools");
        comparisonLabel.setId("contribution-proof");
        comparisonLabel.setWrapText(true);
        comparisonLabel.getStyleClass().add("contribution-proof");
        fillTable();
        VBox.setVgrow(table, Priority.ALWAYS);
        getChildren().addAll(head, table, regionTools, comparisonLabel);
        settleTimer.setOnFinished(_ -> submitQuery());
        VisibilityListener.attach(this, this::subscribe);
    }

    private void fillTable() {
        table.setId("contribution-table");
        table.setAccessibleText(Messages.tr("light contributions"));
        table.setPlaceholder(placeholder);
        table.setColumnResizePolicy(TableView.CONSTRAINED_RESIZE_POLICY_FLEX_LAST_COLUMN);
        TableColumn<LightContribution, Double> impact = column(Messages.tr("Impact If Removed"),
                c -> c.shines() ? impact(c.changeWhenOff()) : -1.0, Object::toString, 240);
        table.getColumns().setAll(List.of(
                column(Messages.tr("Light"), this::title, Function.identity(), 130),
                column(Messages.tr("Whole Frame"), LightContribution::imageShare, PercentText::format, 120),
                column(Messages.tr("Region"), LightContribution::regionShare, PercentText::format, 80),
                column(Messages.tr("Shadow Rays"), this::rayShare, PercentText::format, 100),
                column(Messages.tr("Cursor"), c -> sharesAtPointer.getOrDefault(c.light(), Double.NaN),
                        p -> p.isNaN() ? "–" : PercentText.format(p), 80),
                impact));
        impact.setCellFactory(_ -> new TableCell<>() {
            {
                setTooltip(new Tooltip(Messages.tr(
                        "Share of the displayed pixels that change noticeably (by 4 of 255 levels or more), and the largest change there")));
            }

            @Override
            protected void updateItem(Double item, boolean empty) {
                super.updateItem(item, empty);
                LightContribution contribution = getTableRow() == null ? null : getTableRow().getItem();
                setText(empty || contribution == null ? null : changeText(contribution));
            }
        });
        table.setRowFactory(_ -> {
            TableRow<LightContribution> row = new TableRow<>();
            row.setOnMouseClicked(_ -> light(row).ifPresent(light -> editor.selection().selectLight(light.name())));
            row.setOnContextMenuRequested(e -> light(row)
                    .ifPresent(
                            light -> new ContextMenu(savings(light).toArray(MenuItem[]::new)).show(row, e.getScreenX(), e.getScreenY())));
            return row;
        });
    }

    /** Returns the share of a light in the shadow rays of all, as in their last full trace. */
    private double rayShare(LightContribution contribution) {
        long all = shadowRays.values().stream().mapToLong(Long::longValue).sum();
        return all == 0 || shownScene == null ? 0
                : contribution.light().light(shownScene).map(light -> shadowRays.getOrDefault(light.name(), 0L)).orElse(0L) / (double) all;
    }

    /** Returns what makes a light cheaper. */
    private List<MenuItem> savings(Light light) {
        CommandMenuItems items = CommandMenuItems.forMenu(model.commands());
        List<MenuItem> savings = new ArrayList<>();
        if (light.on()) {
            savings.add(saving(items, Messages.tr("Switch Off"), light.withOn(false)));
        }
        int half = light.area().samples() / 2;
        if (half >= SceneLimits.MIN_LIGHT_SAMPLES) {
            savings.add(saving(items, Messages.tr("Halve Samples"), light.withArea(light.area().withSamples(half))));
        }
        return savings;
    }

    private MenuItem saving(CommandMenuItems items, String title, Light cheaper) {
        return items.value(Command.CONTRIBUTIONS, title,
                () -> editor.editOrReport(scene -> EditOutcome.of(() -> scene.withLight(cheaper))));
    }

    private Optional<Light> light(TableRow<LightContribution> row) {
        return Optional.ofNullable(row.getItem()).flatMap(item -> item.light().light(editor.scene()));
    }

    private String title(LightContribution contribution) {
        return shownScene == null ? "" : contribution.light().title(shownScene);
    }

    private static <T> TableColumn<LightContribution, T> column(String title, Function<LightContribution, T> value,
            Function<T, String> text,
            double width) {
        var column = new TableColumn<LightContribution, T>(title);
        column.setCellValueFactory(c -> new ReadOnlyObjectWrapper<>(value.apply(c.getValue())));
        column.setCellFactory(_ -> new TableCell<>() {
            @Override
            protected void updateItem(T item, boolean empty) {
                super.updateItem(item, empty);
                setText(empty || item == null ? null : text.apply(item));
            }
        });
        column.setPrefWidth(width);
        return column;
    }

    /** Describes how the picture would change without a light. */
    static String changeText(LightContribution contribution) {
        FilmChange change = contribution.changeWhenOff();
        return !contribution.shines() ? Messages.tr("off or black") : change.isNone() ? Messages.tr("bit-identical")
                : change.isInvisible()
                        ? String.format(Messages.locale(), Messages.tr("not visible (difference at most %.1e)"), change.maxDifference())
                : change.noticedShare() == 0 ? Messages.tr("not noticeable")
                : String.format(Messages.locale(), Messages.tr("%s of the pixels, up to %+.1f stops"),
                        PercentText.format(change.noticedShare()), change.noticedStops());
    }

    /** Returns the order of changes: first by what is noticed, then by what differs at all. */
    private static double impact(FilmChange change) {
        return change.noticedShare() > 0 ? 1 + change.noticedShare() : change.isInvisible() ? 0 : 0.5;
    }

    /** Starts to observe the picture. */
    private Subscription subscribe() {
        return Subscription.combine(picture.renderStateProperty().subscribe(state -> updateFrame(state.frame())),
                picture.viewProperty().subscribe(_ -> restart()), model.picturePointer().pixelProperty().subscribe(this::showPixel),
                this::close);
    }

    /** Cancels the queries and ends their threads until the window opens again. */
    private void close() {
        settleTimer.stop();
        lightQuery.close();
        pixelQuery.close();
        lastFrame = null;
        PicturePointer.RegionRequest request = model.picturePointer().regionRequestProperty().get();
        if (request != null) {
            model.picturePointer().regionRequestProperty().set(null);
        }
    }

    private void updateFrame(@Nullable Frame frame) {
        if (frame != null && frame != lastFrame && frame.isFinished()) {
            lastFrame = frame;
            compare(frame);
            restart();
        }
    }

    private void restart() {
        summary.setText(Messages.tr("Computing light contributions …"));
        lightQuery.cancel();
        settleTimer.playFromStart();
    }

    private void submitQuery() {
        RenderOptions options = model.accuracyModeProperty().get().options().withThreads(1);
        ViewTransform view = picture.viewProperty().get().withMarksClipping(false);
        Optional<LightContributions.Region> selected = region;
        lightQuery.submit(
                progress -> model.workbench().cache().map(cache -> new Result(cache.scene(), LightContributions.of(cache, options, view,
                        selected.orElseGet(() -> LightContributions.Region.ofFilm(cache.film())), progress))),
                this::show,
                failure -> summary.setText(ErrorMessage.of(failure)));
    }

    private record Result(Scene scene, LightContributions contributions) {}

    private void show(Result answer) {
        shown = answer.contributions();
        placeholder.setText(Messages.tr("No lights"));
        shownScene = answer.scene();
        shadowRays = model.updates().shadowRays();
        List<TableColumn<LightContribution, ?>> order = List.copyOf(table.getSortOrder());
        table.getItems().setAll(shown.lights());
        table.getSortOrder().setAll(order);
        table.sort();
        int idle = shown.idleLights().size();
        summary.setText(idle == 0 ? Messages.tr("All lights contribute")
                : Messages.count(idle, "1 light changes no displayed pixel: {1}", "{0} lights together change no displayed pixel: {1}",
                        idle,
                        shown.idleLights().stream().map(light -> light.title(answer.scene())).collect(Collectors.joining(", "))));
        switchOffReason.set(idle == 0 ? Optional.of(Messages.tr("all lights contribute")) : Optional.empty());
    }

    private void pickRegion() {
        model.picturePointer().regionRequestProperty()
                .set(new PicturePointer.RegionRequest(Messages.tr("Drag a rectangle around the region to measure"),
                        part -> setRegion(Optional.of(part))));
    }

    private void setRegion(Optional<LightContributions.Region> newRegion) {
        region = newRegion;
        regionText.setText(
                Messages.tr("Region: {0}", newRegion
                        .map(r -> Messages.tr("{0} × {1} pixels at {2}, {3}", r.right() - r.left(), r.bottom() - r.top(), r.left(),
                                r.top()))
                        .orElse(Messages.tr("whole frame"))));
        restart();
    }

    private void showPixel(PicturePointer.@Nullable Pixel pixel) {
        if (pixel == null) {
            pixelQuery.cancel();
            sharesAtPointer = Map.of();
            table.refresh();
            return;
        }
        RenderOptions options = model.accuracyModeProperty().get().options().withThreads(1);
        pixelQuery.submit(progress -> model.workbench().cache()
                .filter(c -> pixel.x() < c.scene().picture().width() && pixel.y() < c.scene().picture().height())
                .map(cache -> pixelShares(LightThumbnails.pixel(cache, options, pixel.x(), pixel.y(), progress))), shares -> {
                    sharesAtPointer = shares;
                    table.refresh();
                }, failure -> editor.message().show(ErrorMessage.of(failure)));
    }

    private static Map<Contribution, Double> pixelShares(LightThumbnails shares) {
        double total = LightThumbnails.brightness(shares.image());
        Map<Contribution, Double> fractions = new HashMap<>();
        for (Contribution part : Contribution.sources(shares.scene())) {
            float[] image = shares.sum(List.of(part));
            fractions.put(part, total > 0 ? LightThumbnails.brightness(image) / total : 0);
        }
        return fractions;
    }

    private void switchOff() {
        Frame frame = picture.frame();
        if (shown == null || shownScene == null || frame == null || !editor.scene().rig().equals(shownScene.rig())) {
            editor.message().show(Messages.tr("The image is out of date; render first (F5)"));
            return;
        }
        List<Contribution> idle = shown.idleLights();
        if (editor.editOrReport(scene -> EditOutcome.of(() -> LightContributions.switchOff(scene, idle))).isEmpty()) {
            pendingComparison = new Comparison(editor.scene(), frame.film(), idle.size());
            comparisonLabel.setText(Messages.tr("Switched off; comparing images …"));
            switchOffReason.set(Optional.of(Messages.tr("comparison in progress")));
            if (!editor.liveProperty().get()) {
                editor.go();
            }
        }
    }

    /** Compares the picture with the one before the lights were switched off. */
    private void compare(Frame frame) {
        Comparison comparison = pendingComparison;
        if (comparison == null) {
            return;
        }
        if (!frame.scene().rig().equals(comparison.scene().rig())) {
            return;
        }
        pendingComparison = null;
        ViewTransform view = picture.viewProperty().get().withMarksClipping(false);
        model.files().runConcurrently(() -> FilmChange.between(comparison.oldFilm(), frame.film(), view),
                change -> comparisonLabel.setText(comparisonText(comparison.lightCount(), change)),
                failure -> comparisonLabel.setText(ErrorMessage.of(failure)));
    }

    static String comparisonText(int lights, FilmChange change) {
        String prefix = Messages.count(lights, "Switched off 1 light: ", "Switched off {0} lights: ", lights);
        return prefix + (change.isNone() ? Messages.tr("the new image is bit-identical to the old one.")
                : change.isInvisible() ? String.format(Messages.locale(),
                        Messages.tr("no displayed pixel changed; %,d linear values differ by at most %.2e."),
                        change.changedValues(),
                        change.maxDifference())
                : String.format(Messages.locale(), Messages.tr("%,d displayed pixels changed."), change.changedPixels()));
    }
}
