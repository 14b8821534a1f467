package lightning.format.review;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Assumptions;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;

/** Chromium without a display that opens a page; skips the test where it is not installed. */
public final class Browser implements AutoCloseable {
    private static final Path CHROMIUM = Path.of("/usr/bin/chromium");
    private static final Path DRIVER = Path.of("/usr/bin/chromedriver");

    private final ChromeDriver driver;

    private Browser(ChromeDriver driver) {
        this.driver = driver;
    }

    /**
     * Opens a page and waits until it shows its picture.
     *
     * @param downloads folder for saved files
     */
    public static Browser open(Path page, Path downloads, int width, int height) {
        return open(page.toUri().toString(), downloads, width, height);
    }

    /** Opens the page of an address as {@link #open(Path, Path, int, int)} does. */
    public static Browser open(String address, Path downloads, int width, int height) {
        Assumptions.assumeTrue(Files.isExecutable(CHROMIUM) && Files.isExecutable(DRIVER), "chromium and chromedriver are not installed");
        var options = new ChromeOptions();
        options.setBinary(CHROMIUM.toString());
        options.addArguments("--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                "--disable-background-networking", "--hide-scrollbars");
        options.setExperimentalOption("prefs", Map.of("download.default_directory", downloads.toString()));
        var logs = new LoggingPreferences();
        logs.enable(LogType.BROWSER, java.util.logging.Level.ALL);
        logs.enable(LogType.PERFORMANCE, java.util.logging.Level.ALL);
        options.setCapability("goog:loggingPrefs", logs);
        var service = new ChromeDriverService.Builder().usingDriverExecutable(DRIVER.toFile()).build();
        var browser = new Browser(new ChromeDriver(service, options));
        browser.driver.manage().window().setSize(new Dimension(width, height));
        browser.driver.get(address);
        browser.waitFor("return document.body.dataset.ready === 'yes'");
        return browser;
    }

    /** Waits until a script returns true, at most a minute. */
    public void waitFor(String script) {
        long end = System.nanoTime() + 60_000_000_000L;
        while (!Boolean.TRUE.equals(run(script))) {
            if (System.nanoTime() > end) {
                throw new AssertionError(
                        "waited in vain for " + script + "; " + run("return document.getElementById('message').textContent") + messages());
            }
            Thread.onSpinWait();
        }
    }

    public ChromeDriver driver() {
        return driver;
    }

    /** Runs a script in the page and returns its value. */
    public Object run(String script, Object... arguments) {
        return driver.executeScript(script, arguments);
    }

    /** Returns red, green and blue of all shown pixels, row by row from the top left. */
    public int[] pixels() {
        List<?> values = (List<?>) run("""
                const canvas = document.getElementById("picture");
                const gl = canvas.getContext("webgl2");
                const bytes = new Uint8Array(4 * canvas.width * canvas.height);
                gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
                const rgb = [];
                for (let y = canvas.height - 1; y >= 0; y--) {
                  for (let x = 0; x < canvas.width; x++) {
                    rgb.push(...bytes.subarray(4 * (y * canvas.width + x), 4 * (y * canvas.width + x) + 3));
                  }
                }
                return rgb;""");
        return values.stream().mapToInt(v -> ((Number) v).intValue()).toArray();
    }

    /** Returns all messages of the browser: errors of the script, and refusals of the security policy. */
    public List<String> messages() {
        return driver.manage().logs().get(LogType.BROWSER).getAll().stream().map(entry -> entry.getMessage())
                // Reading pixels back is slow, and Chromium says so.
                .filter(message -> !message.contains("GPU stall due to ReadPixels")).toList();
    }

    /** Returns the addresses of all requests. */
    public List<String> requests() {
        return driver.manage().logs().get(LogType.PERFORMANCE).getAll().stream().map(entry -> entry.getMessage())
                .filter(message -> message.contains("Network.requestWillBeSent\""))
                .map(message -> message.replaceAll("(?s).*\"url\":\"([^\"]*)\".*", "$1"))
                .toList();
    }

    @Override
    public void close() {
        driver.quit();
    }
}
