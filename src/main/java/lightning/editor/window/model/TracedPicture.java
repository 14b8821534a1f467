package lightning.editor.window.model;

import javafx.beans.binding.Bindings;
import javafx.beans.property.LongProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleLongProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderState;
import lightning.editor.Workbench;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SceneView;
import lightning.scene.Scene;
import lightning.scene.ViewSettings;
import org.jspecify.annotations.Nullable;

/** Traced picture: pixels, render progress and view transform. */
public final class TracedPicture {
    private final ReadOnlyObjectWrapper<RenderState> renderState = new ReadOnlyObjectWrapper<>(RenderState.NONE);
    private final LongProperty repaints = new SimpleLongProperty();
    private final ObjectProperty<ViewTransform> view = new SimpleObjectProperty<>();
    private final Workbench workbench;
    private final TracedRaster raster;
    private final ObjectProperty<ViewSettings> sceneView = new SimpleObjectProperty<>(ViewSettings.DEFAULT);
    private final ObservableValue<ViewTransform> outputView = Bindings.createObjectBinding(this::outputView, view, sceneView);

    /** @param raster  raster that the workbench renders into */
    TracedPicture(Workbench workbench, TracedRaster raster) {
        this.workbench = workbench;
        this.raster = raster;
        view.set(raster.view());
        workbench.setView(view.get());
        view.addListener((_, _, now) -> {
            workbench.setView(now);
            raster.setView(now);
            repaint();
        });
    }

    /** Last picture and the progress of the next one. */
    public ReadOnlyObjectProperty<RenderState> renderStateProperty() {
        return renderState.getReadOnlyProperty();
    }

    /** Returns the last picture, or null before the first. */
    public @Nullable Frame frame() {
        return renderState.get().frame();
    }

    /**
     * Conversion from linear light to display pixels: the scene's view, or false colors until another curve is chosen; with the window's
     * color table and clipping marks.
     */
    public ObjectProperty<ViewTransform> viewProperty() {
        return view;
    }

    /** Returns the conversion for saved images: with the scene's curve, without false colors and marks. */
    public ViewTransform outputView() {
        return view.get().forOutput().withCurve(SceneView.of(sceneView.get().curve()));
    }

    /** See {@link #outputView}. */
    public ObservableValue<ViewTransform> outputViewProperty() {
        return outputView;
    }

    /** Shows the scene's view if it changed. False colors stay. */
    void followScene(Scene scene) {
        ViewSettings settings = scene.picture().view();
        if (!settings.equals(sceneView.get())) {
            sceneView.set(settings);
            DisplayCurve shown = view.get().curve();
            view.set(view.get().withExposure(settings.exposure())
                    .withCurve(shown == DisplayCurve.FALSE ? shown : SceneView.of(settings.curve())));
        }
    }

    public TracedRaster raster() {
        return raster;
    }

    /** Counter that increases whenever the raster may have changed. */
    public LongProperty repaintsProperty() {
        return repaints;
    }

    /** Reports a change of the raster. */
    public void repaint() {
        repaints.set(repaints.get() + 1);
    }

    /** Shows a film rendered on another machine until the local render of the scene is finished. */
    public void showRemote(Film film, Scene scene) {
        raster.showRemote(film, scene);
        repaint();
    }

    /** Updates the picture if the workbench's render state changed. */
    void refresh() {
        if (renderState.get() != workbench.renderState()) {
            update();
        }
    }

    /** Updates the picture, also if only the raster changed. */
    void update() {
        renderState.set(workbench.renderState());
        repaint();
    }
}
