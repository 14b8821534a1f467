package lightning.editor.window.measure;

import lightning.base.text.Messages;
import lightning.render.measure.SweptEffect;
import lightning.render.measure.SweptSetting;

/** Texts of the settings that {@link SettingAccuracyPane} compares. */
final class SettingText {
    private SettingText() {}

    /** Returns the effect's name as a title. */
    static String title(SweptEffect effect) {
        return switch (effect) {
            case INDIRECT -> Messages.tr("Indirect Light");
            case BLURRED_REFLECTIONS -> Messages.tr("Blurred Reflections");
            case SOFT_SHADOWS -> Messages.tr("Soft Shadows");
        };
    }

    /** Returns the setting in words. */
    static String text(SweptSetting setting) {
        return switch (setting) {
            case SweptSetting.Gathering s -> Messages.tr("{0} rays every {1} pixels", s.rays(), s.spacing());
            case SweptSetting.ReflectionRays s -> Messages.tr("{0} Rays", s.rays());
            case SweptSetting.LightSamples s -> Messages.tr("{0} samples", s.samples());
        };
    }

    /** Returns the numbers of the setting alone, for a label in the chart. */
    static String label(SweptSetting setting) {
        return switch (setting) {
            case SweptSetting.Gathering s -> s.spacing() + ", " + s.rays();
            case SweptSetting.ReflectionRays s -> Integer.toString(s.rays());
            case SweptSetting.LightSamples s -> Integer.toString(s.samples());
        };
    }

    /** Returns the end of the id of the setting's point. */
    static String id(SweptSetting setting) {
        return label(setting).replace(", ", "-");
    }
}
