package lightning.sample;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Assumptions;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.WindowType;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;

/**
 * Tab of a page in a Chromium without a display; skips the test where Chromium is not installed. All tests of a Java process use one
 * Chromium, which ends with it.
 */
public final class Browser implements AutoCloseable {
    private static final Path CHROMIUM = Path.of("/usr/bin/chromium");
    private static final Path DRIVER = Path.of("/usr/bin/chromedriver");
    private static final long POLL_MILLIS = 20;

    /** Null before the first page. */
    private static ChromeDriver shared;
    /** Folders of the pages of closed tabs, whose last messages may arrive late. */
    private static final Set<String> CLOSED = new HashSet<>();

    private final ChromeDriver driver;
    /** Tab that stays open, so that Chromium does not end with the last page. */
    private final String emptyTab;

    private final String tab;
    private final String folder;

    private Browser(ChromeDriver driver, String emptyTab, String address) {
        this.driver = driver;
        this.emptyTab = emptyTab;
        tab = driver.getWindowHandle();
        folder = address.substring(0, address.lastIndexOf('/') + 1);
    }

    /**
     * Opens a page and waits until it is ready.
     *
     * @param downloads folder for saved files
     */
    public static Browser open(Path page, Path downloads, int width, int height) {
        return open(page.toUri().toString(), downloads, width, height);
    }

    /** Opens the page of an address as {@link #open(Path, Path, int, int)} does. */
    public static Browser open(String address, Path downloads, int width, int height) {
        Assumptions.assumeTrue(Files.isExecutable(CHROMIUM) && Files.isExecutable(DRIVER), "chromium and chromedriver are not installed");
        if (shared == null) {
            shared = start();
        }
        String emptyTab = shared.getWindowHandle();
        shared.switchTo().newWindow(WindowType.TAB);
        var browser = new Browser(shared, emptyTab, address);
        try {
            browser.load(address, downloads, new Dimension(width, height));
        } catch (RuntimeException | AssertionError e) {
            browser.close();
            throw e;
        }
        return browser;
    }

    private static ChromeDriver start() {
        var options = new ChromeOptions();
        options.setBinary(CHROMIUM.toString());
        options.addArguments("--headless=new", "--no-sandbox", "--disable-gpu-sandbox", "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                "--disable-background-networking", "--hide-scrollbars");
        var logs = new LoggingPreferences();
        logs.enable(LogType.BROWSER, java.util.logging.Level.ALL);
        logs.enable(LogType.PERFORMANCE, java.util.logging.Level.ALL);
        options.setCapability("goog:loggingPrefs", logs);
        var driver = new ChromeDriver(new ChromeDriverService.Builder().usingDriverExecutable(DRIVER.toFile()).build(), options);
        Runtime.getRuntime().addShutdownHook(new Thread(driver::quit));
        return driver;
    }

    private void load(String address, Path downloads, Dimension size) {
        messages();
        requests();
        driver.executeCdpCommand("Browser.setDownloadBehavior", Map.of("behavior", "allow", "downloadPath", downloads.toString()));
        driver.manage().window().setSize(size);
        driver.get(address);
        waitFor("return document.body.dataset.ready === 'yes'");
    }

    /** Waits until a script returns true, at most a minute. */
    public void waitFor(String script) {
        long end = System.nanoTime() + 60_000_000_000L;
        while (!Boolean.TRUE.equals(run(script))) {
            if (System.nanoTime() > end) {
                throw new AssertionError(
                        "waited in vain for " + script + "; " + run("return document.getElementById('message')?.textContent") + messages());
            }
            try {
                Thread.sleep(POLL_MILLIS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new AssertionError("interrupted while waiting for " + script, e);
            }
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

    /** Returns and removes all messages of the browser: errors of the script, and refusals of the security policy. */
    public List<String> messages() {
        return driver.manage().logs().get(LogType.BROWSER).getAll().stream().map(entry -> entry.getMessage())
                .filter(message -> CLOSED.stream().noneMatch(message::startsWith))
                // Reading pixels back is slow, and Chromium says so.
                .filter(message -> !message.contains("GPU stall due to ReadPixels")).toList();
    }

    /** Returns and removes the addresses of all requests. */
    public List<String> requests() {
        return driver.manage().logs().get(LogType.PERFORMANCE).getAll().stream().map(entry -> entry.getMessage())
                .filter(message -> message.contains("Network.requestWillBeSent\"") && message.contains(tab))
                .map(message -> message.replaceAll("(?s).*\"url\":\"([^\"]*)\".*", "$1"))
                .toList();
    }

    @Override
    public void close() {
        CLOSED.add(folder);
        driver.close();
        driver.switchTo().window(emptyTab);
    }
}
