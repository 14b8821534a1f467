package lightning.editor.window.traced;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javafx.event.Event;
import javafx.event.EventType;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.Slider;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.KeyCode;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import lightning.base.math.Vec3;
import lightning.document.AttributeNumber;
import lightning.document.DeskScene;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.FastRobot;
import lightning.editor.window.OwnEditor;
import lightning.editor.window.ScreenBounds;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.InsetPlace;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.widget.PictureView;
import lightning.editor.window.widget.TextTyping;
import lightning.format.image.CubeLutReader;
import lightning.format.image.ImageFile;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.ContributionScene;
import lightning.render.shading.explanation.LightReport;
import lightning.render.shading.explanation.PixelExplainer;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.Scene;
import lightning.scene.ViewCurve;
import lightning.scene.ViewSettings;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import org.junit.jupiter.api.Test;
import org.testfx.util.WaitForAsyncUtils;

class TracedPaneTest extends EditorFixture {

    /** Returns the screen position of a pixel of the traced picture. */
    private Point2D pixel(double x, double y) {
        PictureView picture = robot.lookup("#traced-picture").query();
        Bounds all = ScreenBounds.of(picture.getChildrenUnmodifiable().getFirst());
        return new Point2D(all.getMinX() + (x + 0.5) * all.getWidth() / 64, all.getMinY() + (y + 0.5) * all.getHeight() / 48);
    }

    @Test
    void progress_doesNotCoverThePixelReport() {
        robot.interact(() -> {
            robot.lookup("#pixel-lights").<Label>query()
                    .setText("a light with a very long name, which reaches the middle of the pane\n".repeat(3));
            Node progress = robot.lookup("#progress").query();
            progress.setVisible(true);
        });
        WaitForAsyncUtils.waitForFxEvents();
        Node card = robot.lookup("#pixel-lights").query();
        Node progress = robot.lookup("#progress").query();
        // Both are in the stack of the picture. The bounds of the progress have a shadow, too.
        assertThat(card.getLayoutY() + card.getTranslateY() + card.getLayoutBounds().getHeight()).isLessThan(progress.getLayoutY());
    }

    @Test
    void narrowPane_shortensTheBarOfProgress_notItsTitle() {
        robot.interact(() -> {
            HBox overlay = robot.lookup("#progress").query();
            Label title = (Label) overlay.getChildren().getFirst();
            title.setText("Indirect light… 12 s left");
            overlay.applyCss();
            overlay.resize(280, 40);
            overlay.layout();
            assertThat(title.getWidth()).isGreaterThanOrEqualTo(title.prefWidth(-1));
        });
    }

    @Test
    void progress_namesEachStepOfAnImport() {
        Path file = Path.of("chair.glb");
        Label title = (Label) robot.lookup("#progress").<HBox>query().getChildren().getFirst();
        robot.interact(() -> model().fileActivity().beginReading(file));
        waitFor("the file is read", () -> title.getText().equals("Reading chair.glb"));
        robot.interact(() -> model().fileActivity().setTitle(file, "Previewing"));
        waitFor("the next step has its own title", () -> title.getText().equals("Previewing chair.glb"));
        robot.interact(() -> model().fileActivity().end(file));
    }

    @Test
    void hover_showsShapeAndLightShares() {
        robot.moveTo(pixel(32, 24));
        waitFor("the text is shown", () -> text("pixel").startsWith("32, 24  ball"));
        Film film = model().picture().frame().film();
        int shown = ViewTransform.DEFAULT.pack(film.red(32, 24), film.green(32, 24), film.blue(32, 24));
        double luminance = 0.2126 * film.red(32, 24) + 0.7152 * film.green(32, 24) + 0.0722 * film.blue(32, 24);
        assertThat(text("pixel")).startsWith("32, 24").contains("normal").contains(String.format(Locale.ROOT,
                "%.3f %.3f %.3f → %d %d %d  %+.1f stops", film.red(32, 24), film.green(32, 24), film.blue(32, 24), shown >> 16 & 0xFF,
                shown >> 8 & 0xFF, shown & 0xFF, Math.log(luminance / 0.18) / Math.log(2)));
        assertThat(text("pixel-lights")).contains("lamp  ").contains("sun  ").contains("stage  ").contains(" %");
    }

    @Test
    void hoverOverBackground_showsBackground() {
        robot.moveTo(pixel(2, 1));
        waitFor("the text is shown", () -> text("pixel").contains("background"));
    }

    @Test
    void doubleClick_selectsStrongestLight() {
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "stage", 50)));
        click("go");
        waitForPicture();
        robot.interact(() -> model().editor().selection().selectLight("sun"));
        robot.doubleClickOn(pixel(36, 22));
        waitFor("the light is selected",
                () -> model().editor().selection().light() != null && model().editor().selection().light().name().equals("stage"));
    }

    @Test
    void click_selectsTheObject() {
        robot.interact(() -> model().editor().selection().selectLight("sun"));
        robot.clickOn(pixel(32, 24));
        waitFor("the object is selected", () -> model().editor().selection().node().filter(node -> node.name().equals("ball")).isPresent());
        assertThat(model().editor().selection().light()).isNull();
    }

    @Test
    void picture_duringZoom_staysUnderPointer() {
        Point2D before = pixel(32, 24);
        robot.moveTo(before);
        waitFor("the text is shown", () -> text("pixel").contains("ball"));
        assertThat(pixel(32, 24)).isEqualTo(before);
        robot.moveTo(pixel(0, 0));
        waitFor("the text is shown", () -> !text("pixel").contains("ball"));
        assertThat(pixel(32, 24)).isEqualTo(before);
    }

    @Test
    void aim_pointsLightAtPickedPoint() {
        robot.interact(() -> {
            model().editor().selection().selectLight("stage");
            model().commands().run(Command.AIM);
        });
        robot.clickOn(pixel(32, 24));
        waitFor("the light is aimed", () -> model().commands().isEnabled(Command.UNDO));
        Vec3 direction = light("stage").direction().normalized();
        Vec3 toBall = new Vec3(0, 1, 0).minus(light("stage").position()).normalized();
        assertThat(direction.dot(toBall)).isGreaterThan(0.85);
    }

    @Test
    void placedHighlight_isBrightestAtPoint() {
        robot.interact(() -> {
            model().editor().selection().selectLight("lamp");
            model().commands().run(Command.PLACE_HIGHLIGHT);
        });
        assertThat(text("prompt")).startsWith("Click or drag where the highlight");
        robot.clickOn(pixel(28, 22));
        waitFor("the light is placed", () -> model().commands().isEnabled(Command.UNDO));
        var placed = new PixelExplainer(model().editor().scene()).explainPixel(28, 22).lights().getFirst();
        assertThat(placed.light().name()).isEqualTo("lamp");
        assertThat(placed.specular()).isGreaterThan(0.99f);
    }

    @Test
    void placedShadow_fallsOnPoint() {
        robot.interact(() -> {
            model().editor().selection().selectLight("lamp");
            model().commands().run(Command.PLACE_SHADOW);
        });
        robot.clickOn(pixel(32, 22));
        waitFor("the prompt requests the shadow's position", () -> text("prompt").startsWith("Click or drag where the shadow"));
        robot.clickOn(pixel(46, 36));
        waitFor("the light is placed", () -> model().commands().isEnabled(Command.UNDO));
        var placed = new PixelExplainer(model().editor().scene()).explainPixel(46, 36).lights().getFirst();
        assertThat(placed.state()).isEqualTo(LightReport.State.SHADOWED);
    }

    @Test
    void snapshot_isComparedByWipe() {
        click("snapshot");
        robot.interact(() -> model().editor().edit(scene -> AttributeNumber.AMBIENCE.set(scene, "", 5)));
        click("go");
        waitForPicture();
        click("compare");
        robot.drag(pixel(32, 24), MouseButton.PRIMARY);
        robot.dropTo(pixel(47.5, 24));
        PictureView picture = robot.lookup("#traced-picture").query();
        assertThat(picture.wipe().share()).isCloseTo(0.75, within(0.01));
        assertThat(picture.wipe().isVisible()).isTrue();
    }

    @Test
    void rightClick_endsPicking() {
        Vec3 before = light("stage").direction();
        robot.interact(() -> {
            model().editor().selection().selectLight("stage");
            model().commands().run(Command.AIM);
        });
        robot.clickOn(pixel(32, 24), MouseButton.SECONDARY);
        assertThat(isShown("prompt")).isFalse();
        robot.clickOn(pixel(32, 24));
        assertThat(light("stage").direction()).isEqualTo(before);
    }

    @Test
    void prompt_isShownUntilEscape() {
        robot.interact(() -> model().commands().run(Command.PLACE_HIGHLIGHT));
        Bounds promptBounds = ScreenBounds.of(robot.lookup("#prompt").query());
        Bounds canvas = ScreenBounds.of(robot.lookup("#traced-picture").query());
        assertThat(canvas.contains(promptBounds)).isTrue();
        robot.push(KeyCode.ESCAPE);
        assertThat(isShown("prompt")).isFalse();
        click("region");
        assertThat(text("prompt")).startsWith("Drag a rectangle");
        robot.push(KeyCode.ESCAPE);
        assertThat(robot.lookup("#region").<ToggleButton>query().isSelected()).isFalse();
    }

    private TracedPane traced() {
        return robot.lookup("#traced").query();
    }

    @Test
    void typedExposure_acceptsAnyNumber() {
        TextTyping.replace(robot, robot.lookup("#exposure-stops").query(), "-1.37").push(KeyCode.ENTER);
        assertThat(model().picture().viewProperty().get().exposure()).isEqualTo(-1.37);
        assertThat(robot.lookup("#exposure").<Slider>query().getValue()).isEqualTo(-1.37);
        TextTyping.replace(robot, robot.lookup("#exposure-stops").query(), "9").push(KeyCode.ENTER);
        assertThat(model().picture().viewProperty().get().exposure()).isEqualTo(-1.37);
        assertThat(text("message")).containsIgnoringCase("exposure must be from -8 to 8");
    }

    /** Dragging by one pixel changes the exposure by at most a quarter of a stop. */
    @Test
    void exposureSlider_isWideEnough() {
        widenPane();
        Slider slider = robot.lookup("#exposure").query();
        assertThat((slider.getMax() - slider.getMin()) / slider.getWidth()).isLessThan(0.12);
        robot.drag(slider, MouseButton.PRIMARY).dropBy(4, 0);
        assertThat(model().picture().viewProperty().get().exposure()).isBetween(0.1, 0.8);
    }

    @Test
    void exposure_changesOnlyDisplay() {
        int[] before = model().picture().raster().pixels().pixels().clone();
        robot.interact(() -> robot.lookup("#exposure").<Slider>query().setValue(1));
        assertThat(model().picture().raster().pixels().pixels()).isNotEqualTo(before)
                .isEqualTo(new ViewTransform(1).toPixels(model().picture().frame().film()));
        assertThat(model().editor().scene().picture().view()).isEqualTo(new ViewSettings(ViewCurve.SRGB, 1));
        assertThat(model().editor().document().isDirty()).isTrue();
        assertThat(model().editor().editorStateProperty().get().hasPendingEdits()).isFalse();
        click("undo");
        assertThat(model().picture().raster().pixels().pixels()).isEqualTo(before);
        assertThat(model().editor().document().isDirty()).isFalse();
    }

    @Test
    void exposureDrag_isOneUndoStep() {
        widenPane();
        robot.drag(robot.lookup("#exposure").<Slider>query(), MouseButton.PRIMARY).moveBy(10, 0).moveBy(10, 0).dropBy(10, 0);
        assertThat(model().editor().scene().picture().view().exposure()).isGreaterThan(0.5);
        click("undo");
        assertThat(model().editor().scene().picture().view().exposure()).isZero();
        assertThat(robot.lookup("#exposure").<Slider>query().getValue()).isZero();
    }

    /** The presses of a double-click next to the thumb are no edits themselves. */
    @Test
    void exposureDoubleClick_resetsInOneUndoStep() {
        widenPane();
        robot.interact(() -> robot.lookup("#exposure").<Slider>query().setValue(2));
        robot.doubleClickOn(robot.lookup("#exposure").<Slider>query());
        assertThat(model().editor().scene().picture().view().exposure()).isZero();
        click("undo");
        assertThat(model().editor().scene().picture().view().exposure()).isEqualTo(2);
    }

    /** A hand moves a little between the presses. */
    @Test
    void exposureDoubleClick_ignoresSmallMovements() {
        Slider slider = robot.lookup("#exposure").query();
        robot.interact(() -> slider.setValue(2));
        robot.moveTo(slider).press(MouseButton.PRIMARY).moveBy(1, 0).release(MouseButton.PRIMARY).clickOn(MouseButton.PRIMARY);
        assertThat(model().editor().scene().picture().view().exposure()).isIn(0.0, 2.0);
        click("undo");
        assertThat(model().editor().scene().picture().view().exposure()).isIn(0.0, 2.0);
    }

    @Test
    void curve_isEditOfScene() {
        choose("view-agx");
        assertThat(model().editor().scene().picture().view()).isEqualTo(new ViewSettings(ViewCurve.AGX, 0));
        assertThat(model().picture().viewProperty().get().curve()).isEqualTo(DisplayCurve.AGX);
        assertThat(model().editor().editorStateProperty().get().undoLabel()).contains("view transform srgb → agx");
        assertThat(model().editor().editorStateProperty().get().hasPendingEdits()).isFalse();
        click("undo");
        assertThat(model().picture().viewProperty().get()).isEqualTo(ViewTransform.DEFAULT);
        assertThat(model().editor().document().isDirty()).isFalse();
    }

    /** Analysis views belong to the window: not to the scene, the undo history, saved images or the preferences. */
    @Test
    @OwnEditor
    void analysisViews_areNotStored() throws IOException {
        choose("view-agx");
        Scene scene = model().editor().scene();
        choose("view-false");
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.K);
        assertThat(model().picture().viewProperty().get().curve()).isEqualTo(DisplayCurve.FALSE);
        assertThat(model().picture().viewProperty().get().marksClipping()).isTrue();
        assertThat(model().editor().scene()).isSameAs(scene);
        assertThat(model().picture().outputView()).isEqualTo(ViewTransform.DEFAULT.withCurve(DisplayCurve.AGX));
        choose("view-reflections");
        robot.interact(() -> model().accuracyModeProperty().set(AccuracyMode.values()[1]));
        waitFor("the preferences are saved", () -> Files.readString(folder.resolve("own/preferences.properties")).contains("precision"));
        assertThat(Files.readString(folder.resolve("own/preferences.properties"))).doesNotContain("curve", "FALSE", "lipping");
        choose("view-agx");
        assertThat(model().picture().viewProperty().get().curve()).isEqualTo(DisplayCurve.AGX);
        assertThat(model().editor().scene()).isSameAs(scene);
    }

    private void choose(String id) {
        MenuButton menu = robot.lookup("#view-options").query();
        robot.interact(() -> {
            MenuItem item = menu.getItems().stream().filter(i -> id.equals(i.getId())).findFirst().orElseThrow();
            if (item instanceof CheckMenuItem check) {
                check.setSelected(!check.isSelected());
            }
            item.fire();
        });
    }

    @Test
    void view1998_showsTheLinearValues() {
        choose("view-1998");
        assertThat(model().picture().raster().pixels().pixels()).isEqualTo(
                ViewTransform.DEFAULT.withCurve(DisplayCurve.LINEAR).toPixels(model().picture().frame().film()));
        robot.interact(() -> robot.lookup("#exposure").<Slider>query().setValue(1));
        assertThat(model().picture().viewProperty().get()).isEqualTo(new ViewTransform(1, DisplayCurve.LINEAR));
        choose("view-srgb");
        assertThat(model().picture().raster().pixels().pixels()).isEqualTo(new ViewTransform(1).toPixels(model().picture().frame().film()));
    }

    @Test
    void falseColor_showsLegend() {
        assertThat(isShown("stop-legend")).isFalse();
        choose("view-false");
        assertThat(model().picture().raster().pixels().pixels())
                .isEqualTo(ViewTransform.DEFAULT.withCurve(DisplayCurve.FALSE).toPixels(model().picture().frame().film()));
        assertThat(isShown("stop-legend")).isTrue();
        choose("view-aces");
        assertThat(model().picture().raster().pixels().pixels())
                .isEqualTo(ViewTransform.DEFAULT.withCurve(DisplayCurve.ACES).toPixels(model().picture().frame().film()));
        assertThat(isShown("stop-legend")).isFalse();
    }

    @Test
    @OwnEditor
    void colorTable_isAppliedStoredAndRemoved() throws IOException {
        answer = Files.writeString(folder.resolve("inverse.cube"), "LUT_1D_SIZE 2\n1 1 1\n0 0 0\n");
        int[] before = model().picture().raster().pixels().pixels().clone();
        choose("view-color-table");
        waitFor("the table is read", () -> model().picture().viewProperty().get().lut().isPresent());
        ViewTransform inverse = ViewTransform.DEFAULT.withLut(Optional.of(CubeLutReader.read(answer)));
        assertThat(model().picture().raster().pixels().pixels()).isEqualTo(inverse.toPixels(model().picture().frame().film()))
                .isNotEqualTo(before);
        assertThat(model().editor().message().textProperty().get()).isEqualTo("Loaded LUT inverse.cube, 3 × 2");
        waitFor("the preference is saved", () -> Files.readString(folder.resolve("own/preferences.properties")).contains("inverse.cube"));
        choose("view-color-table");
        assertThat(model().picture().raster().pixels().pixels()).isEqualTo(before);
    }

    @Test
    void clippedPixels_areMarkedWithLegend() {
        robot.interact(() -> model().picture().viewProperty().set(new ViewTransform(3)));
        assertThat(isShown("clipping-legend")).isFalse();
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.K);
        assertThat(isShown("clipping-legend")).isTrue();
        Film film = model().picture().frame().film();
        int marked = 0;
        int[] shown = model().picture().raster().pixels().pixels();
        for (int i = 0; i < shown.length; i++) {
            int x = i % film.width();
            int y = i / film.width();
            boolean over = 8 * Math.max(Math.max(film.red(x, y), film.green(x, y)), film.blue(x, y)) > 1;
            assertThat(shown[i] == (0xFF000000 | ViewTransform.CLIPPED_MARK)).as("pixel %s %s", x, y).isEqualTo(over);
            marked += over ? 1 : 0;
        }
        assertThat(marked).isPositive();
        robot.push(KeyCode.CONTROL, KeyCode.SHIFT, KeyCode.K);
        assertThat(model().picture().raster().pixels().pixels()).isEqualTo(new ViewTransform(3).toPixels(film));
        assertThat(isShown("clipping-legend")).isFalse();
    }

    @Test
    void onlySelected_showsSelectedLightsContribution() {
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        click("only-selected");
        waitFor("the look is shown", () -> isShown("look"));
        assertThat(text("look")).isEqualTo("View: Only stage");
        assertCanvasShows(new ReferenceTracer(ContributionScene.of(model().editor().scene(), "stage")).trace());
        robot.interact(() -> model().editor().selection().selectLight("sun"));
        waitFor("the other look is shown", () -> text("look").equals("View: Only sun"));
        assertCanvasShows(new ReferenceTracer(ContributionScene.of(model().editor().scene(), "sun")).trace());
        click("only-selected");
        waitFor("the full picture is shown", () -> !isShown("look"));
        assertCanvasShows(new ReferenceTracer(model().editor().scene()).trace());
    }

    @Test
    void onlySelected_affectsNeitherSceneNorSavingNorVerify() throws IOException {
        click("only-selected");
        waitFor("the look is shown", () -> isShown("look"));
        assertThat(model().editor().document().isDirty()).isFalse();
        assertThat(isEnabled(Command.GO)).isFalse();
        answer = folder.resolve("whole.pfm");
        click("save-image");
        waitFor("the file is written", () -> text("message").equals("Saved whole.pfm"));
        assertThat(ImageFile.read(answer).hasSameBits(new ReferenceTracer(model().editor().scene()).trace())).isTrue();
        click("verify");
        waitFor("the picture is verified", () -> model().picture().renderStateProperty().get().verification() != null);
        assertThat(text("status")).startsWith("Verified: equal to a full trace in every bit");
    }

    @Test
    void onlySelected_afterRename_keepsLight() {
        robot.interact(() -> model().editor().selection().selectLight("stage"));
        click("only-selected");
        waitFor("the look is shown", () -> isShown("look"));
        robot.interact(() -> model().editor().edit(scene -> LightEdits.rename(scene, "stage", "rim")));
        assertCanvasShows(new ReferenceTracer(ContributionScene.of(model().picture().frame().scene(), "stage")).trace());
    }

    @Test
    void hiddenEffect_isLabeledAndAffectsOnlyCanvas() {
        choose("view-reflections");
        waitFor("the look is shown", () -> isShown("look"));
        assertThat(text("look")).isEqualTo("View: No reflections");
        assertCanvasShows(
                new ReferenceTracer(ViewEffects.ALL.with(RenderEffect.REFLECTION, false).apply(model().editor().scene())).trace());
        assertFilmIs(new ReferenceTracer(model().editor().scene()).trace());
        assertThat(robot.lookup("#region").query().isDisabled()).isTrue();
    }

    @Test
    void region_showsEditsOnlyInside() {
        int[] before = model().picture().raster().pixels().pixels().clone();
        robot.interact(() -> model().editor().edit(scene -> AttributeNumber.AMBIENCE.set(scene, "", 5)));
        click("region");
        robot.drag(pixel(28, 20), MouseButton.PRIMARY);
        robot.dropTo(pixel(36, 28));
        waitFor("the region is traced", () -> model().picture().raster().isPatched());
        int[] after = model().picture().raster().pixels().pixels();
        assertThat(after[24 * 64 + 32]).isNotEqualTo(before[24 * 64 + 32]);
        assertThat(after[40 * 64 + 10]).isEqualTo(before[40 * 64 + 10]);
        assertThat(isEnabled(Command.GO)).isTrue();
        waitFor("the message is shown", () -> text("pending").equals("The region is newer than the rest of the image"));
        click("undo");
        assertThat(text("pending")).isEqualTo("The region is out of date");
        click("redo");
        click("go");
        waitForPicture();
        assertThat(model().picture().raster().pixels().pixels())
                .isEqualTo(model().picture().raster().view().toPixels(model().picture().frame().film()));
    }

    @Test
    void regionWithoutEdits_showsNoBadge() {
        click("region");
        robot.drag(pixel(28, 20), MouseButton.PRIMARY);
        robot.dropTo(pixel(36, 28));
        waitFor("the region is traced", () -> model().picture().raster().isPatched());
        robot.interact(model().picture()::repaint);
        assertThat(isShown("pending")).isFalse();
    }

    @Test
    void actualSize_mapsPixelsOneToOne() {
        widenPane();
        click("traced-one-to-one");
        PictureView picture = robot.lookup("#traced-picture").query();
        assertThat(picture.magnification()).isEqualTo(1);
        click("traced-fit");
        assertThat(picture.magnification()).isGreaterThan(2);
    }

    /** A narrow pane leaves out some controls of its header. */
    private void widenPane() {
        robot.interact(() -> model().layout().canvasLayoutProperty().set(CanvasLayout.PICTURE_ALONE));
        FastRobot.settle();
    }

    @Test
    void inset_isBesideTheSquarePicture_andNeverCoversMoreThanAFifth() {
        assertThat(PictureInset.largestWidth(1000, 570, 1)).as("beside").isEqualTo(215);
        assertThat(PictureInset.largestWidth(1000, 570, 4 / 3.0)).as("no room beside").isEqualTo(300);
        double alone = PictureInset.largestWidth(500, 900, 1);
        assertThat(alone * alone).isLessThanOrEqualTo(0.2 * 500 * 500);
    }

    /** Drags a handle of the inset to a place, in shares of the pane. */
    private void drag(String handle, double x, double y) {
        robot.interact(() -> model().layout().canvasLayoutProperty().set(CanvasLayout.PICTURE_LARGE));
        FastRobot.settle();
        Node at = robot.lookup("#" + handle).query();
        Node area = robot.lookup("#traced-picture").query().getParent();
        robot.interact(() -> {
            // Not by the robot, because the headless platform sends drags to the node under the mouse.
            send(at, MouseEvent.MOUSE_PRESSED, at.localToScene(0, 0));
            Point2D to = area.localToScene(x * area.getLayoutBounds().getWidth(), y * area.getLayoutBounds().getHeight());
            send(at, MouseEvent.MOUSE_DRAGGED, to);
            send(at, MouseEvent.MOUSE_RELEASED, to);
        });
    }

    private static void send(Node node, EventType<MouseEvent> type, Point2D at) {
        Event.fireEvent(node, new MouseEvent(type, at.getX(), at.getY(), 0, 0, MouseButton.PRIMARY, 1, false, false, false, false, true,
                false, false, false, false, true, null));
    }

    @Test
    void dragOfHandle_movesInsetToNearestCorner() {
        robot.interact(() -> model().layout().insetPlaceProperty().set(InsetPlace.INITIAL));
        drag("inset-move", 0.2, 0.9);
        assertThat(model().layout().insetPlaceProperty().get()).isEqualTo(new InsetPlace(InsetPlace.Corner.BOTTOM_LEFT, 1));
        drag("inset-move", 0.6, 0.1);
        assertThat(model().layout().insetPlaceProperty().get()).isEqualTo(InsetPlace.INITIAL);
    }

    @Test
    void dragOfInnerCorner_makesInsetSmaller() {
        robot.interact(() -> model().layout().insetPlaceProperty().set(InsetPlace.INITIAL));
        drag("inset-size", 0.9, 0.1);
        assertThat(model().layout().insetPlaceProperty().get().corner()).isEqualTo(InsetPlace.Corner.TOP_RIGHT);
        assertThat(model().layout().insetPlaceProperty().get().size()).isLessThan(0.9);
        robot.interact(() -> model().layout().insetPlaceProperty().set(InsetPlace.INITIAL));
    }

    @Test
    void oneKey_hidesInsetAndShowsItAgain() {
        robot.interact(() -> model().layout().canvasLayoutProperty().set(CanvasLayout.PICTURE_LARGE));
        robot.push(KeyCode.F12);
        assertThat(model().layout().canvasLayoutProperty().get()).isEqualTo(CanvasLayout.PICTURE_ALONE);
        robot.push(KeyCode.F12);
        assertThat(model().layout().canvasLayoutProperty().get()).isEqualTo(CanvasLayout.PICTURE_LARGE);
    }
}
